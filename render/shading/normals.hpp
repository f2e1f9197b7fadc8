#pragma once

#include "render/shading/shading.hpp"
#include "scene/build_scene.hpp"

#include <vector>

namespace planetree::render {

/// The normals as colours: 0.5 + 0.5 n, for the side that faces the viewer. Measured are the
/// components themselves.
class Normals final : public Shading {
 public:
  /// Those of the geometry.
  Normals() = default;
  /// Those that shading takes: interpolated where the corners of a mesh have some. The scene must
  /// outlive the shading.
  explicit Normals(const scene::BuiltScene& scene) noexcept : scene_(&scene) {}

  [[nodiscard]] std::vector<FilmSample> shade(RayCounter& tracer,
                                              CameraRays& camera) const override;
  [[nodiscard]] Development develop(const Film& film) const override;

 private:
  const scene::BuiltScene* scene_ = nullptr;
};

}  // namespace planetree::render
