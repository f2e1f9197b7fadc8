#pragma once

#include "render/shading/shading.hpp"

#include "render/camera.hpp"
#include "scene/build_scene.hpp"

#include <planetree/geometry/box3.hpp>

#include <vector>

namespace planetree::render {

/// Ambient occlusion: a surface has the light of a bright dome, times the part of the directions in
/// which nothing near stands in the way. Each camera ray that sees a surface tries a few
/// directions: that gives less noise for the time than more camera rays, many of which see nothing.
/// Light and openness are multiplied, not traced together, so that open surfaces show no noise.
class AmbientOcclusion final : public Shading {
 public:
  /// `axes` are those of the camera: the light comes from above its left shoulder, so that every
  /// model is lit in the same way. `albedos` are the colours of the geometries, in linear light;
  /// those without one are the colour of clay.
  AmbientOcclusion(const Box3& bounds, const CameraAxes& axes, const Vec3f& up,
                   std::vector<Vec3f> albedos);
  /// The same, in the colours of a scene, which must outlive the shading.
  AmbientOcclusion(const scene::BuiltScene& scene, const CameraAxes& axes, const Vec3f& up);

  [[nodiscard]] std::vector<FilmSample> shade(RayCounter& tracer,
                                              CameraRays& camera) const override;
  [[nodiscard]] Development develop(const Film& film) const override;

 private:
  /// Those that each surface sends, one after the other.
  [[nodiscard]] std::vector<Rayf> raysFromSurfaces(const CameraRays& camera,
                                                   const std::vector<Hitf>& hits) const;
  [[nodiscard]] Vec3f albedo(const Rayf& ray, const Hitf& hit) const;
  /// The light on a surface from which nothing is blocked.
  [[nodiscard]] Vec3f openLight(const Vec3f& normal) const noexcept;

  Box3 bounds_;
  float reach_;  ///< how far away a surface can still shade
  Vec3f up_;
  Vec3f keyDirection_;
  std::vector<Vec3f> albedos_;
  const scene::BuiltScene* scene_ = nullptr;
};

}  // namespace planetree::render
