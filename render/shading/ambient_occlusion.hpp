#pragma once

#include "render/shading/shading.hpp"

#include "render/camera.hpp"

#include <planetree/geometry/box3.hpp>

#include <vector>

namespace planetree::render {

/// Ambient occlusion: a surface is lit by a bright dome wherever nothing near stands in the way.
/// Each camera ray that sees a surface sends one ray to the dome.
class AmbientOcclusion final : public Shading {
 public:
  /// `axes` are those of the camera: the light comes from above its left shoulder, so that every
  /// model is lit in the same way. `albedos` are the colours of the geometries, in linear light;
  /// those without one are the colour of clay.
  AmbientOcclusion(const Box3& scene, const CameraAxes& axes, const Vec3f& up,
                   std::vector<Vec3f> albedos);

  [[nodiscard]] FilmSample shade(RayCounter& tracer, const Rayf& cameraRay,
                                 const Point2& direction) const noexcept override;
  [[nodiscard]] DevelopedImage develop(const Film& film) const override;

 private:
  [[nodiscard]] Vec3f albedo(const Hitf& hit) const noexcept;
  [[nodiscard]] Vec3f domeLight(const Vec3f& direction) const noexcept;

  Box3 scene_;
  float reach_;  ///< how far away a surface can still shade
  Vec3f up_;
  Vec3f keyDirection_;
  std::vector<Vec3f> albedos_;
};

}  // namespace planetree::render
