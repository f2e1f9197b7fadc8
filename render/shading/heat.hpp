#pragma once

#include "render/shading/shading.hpp"

namespace planetree::render {

/// The work of finding what each camera ray sees, as colours: split nodes visited and objects
/// tested. Rays that hit nothing have their work shown too. The brightest colour stands for the
/// 99.5th percentile of the pixels, so that a few costly ones leave the rest its contrast.
class Heat final : public Shading {
 public:
  [[nodiscard]] FilmSample shade(RayCounter& tracer, const Rayf& cameraRay,
                                 const DirectionPoints& directions) const noexcept override;
  [[nodiscard]] DevelopedImage develop(const Film& film) const override;
};

}  // namespace planetree::render
