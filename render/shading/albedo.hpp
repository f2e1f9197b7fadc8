#pragma once

#include "render/shading/shading.hpp"
#include "scene/build_scene.hpp"

#include <vector>

namespace planetree::render {

/// The colour of a surface itself: the part of light that it scatters, as a screen shows it.
/// Materials hold what the screen is sent, see material.hpp; as light it is decoded.
[[nodiscard]] Vec3f diffuseColour(const scene::SurfacePoint& surface) noexcept;

/// The same with the light that it mirrors and lets through: glass is not black.
[[nodiscard]] Vec3f passedOnColour(const scene::SurfacePoint& surface) noexcept;

/// The diffuse colours of the surfaces, without any light. Measured is the same as a layer.
class Albedo final : public Shading {
 public:
  /// The scene must outlive the shading.
  explicit Albedo(const scene::BuiltScene& scene) noexcept : scene_(scene) {}

  [[nodiscard]] std::vector<FilmSample> shade(RayCounter& tracer,
                                              CameraRays& camera) const override;
  [[nodiscard]] Development develop(const Film& film) const override;

 private:
  const scene::BuiltScene& scene_;
};

}  // namespace planetree::render
