#pragma once

#include "render/shading/shading.hpp"

#include <vector>

namespace planetree::render {

/// The geometric normals as colours: 0.5 + 0.5 n, for the side that faces the viewer. Measured are
/// the components themselves.
class Normals final : public Shading {
 public:
  [[nodiscard]] std::vector<FilmSample> shade(RayCounter& tracer,
                                              const CameraRays& camera) const override;
  [[nodiscard]] Development develop(const Film& film) const override;
};

}  // namespace planetree::render
