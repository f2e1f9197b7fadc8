#pragma once

#include "render/shading/shading.hpp"

namespace planetree::render {

/// The geometric normals as colours: 0.5 + 0.5 n, for the side that faces the viewer. Measured are
/// the components themselves.
class Normals final : public Shading {
 public:
  [[nodiscard]] FilmSample shade(RayCounter& tracer, const Rayf& cameraRay,
                                 const DirectionPoints& directions) const noexcept override;
  [[nodiscard]] Development develop(const Film& film) const override;
};

}  // namespace planetree::render
