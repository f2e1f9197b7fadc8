#pragma once

#include "render/shading/shading.hpp"

#include <planetree/geometry/vec3.hpp>

#include <vector>

namespace planetree::render {

/// Depth along the view direction as grey: the nearest surface is white, the farthest dark, and
/// what is not there is black. The range is that of the surfaces in the picture. Measured is the
/// depth itself, infinite where nothing is.
class Depth final : public Shading {
 public:
  explicit Depth(const Vec3f& viewDirection) : viewDirection_(viewDirection) {}

  [[nodiscard]] std::vector<FilmSample> shade(RayCounter& tracer,
                                              CameraRays& camera) const override;
  [[nodiscard]] Development develop(const Film& film) const override;

 private:
  Vec3f viewDirection_;
};

}  // namespace planetree::render
