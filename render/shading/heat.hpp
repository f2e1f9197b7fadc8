#pragma once

#include "render/shading/shading.hpp"

#include <optional>
#include <vector>

namespace planetree::render {

/// The work of finding what each camera ray sees, as colours: split nodes visited and objects
/// tested. Rays that hit nothing have their work shown too. Black is no work at all. Unless it is
/// given, the work that the brightest colour stands for is the 99.5th percentile of the pixels,
/// rounded up to two digits, so that a few costly ones leave the rest its contrast.
class Heat final : public Shading {
 public:
  /// `brightest` must be positive.
  explicit Heat(std::optional<double> brightest = std::nullopt) noexcept : brightest_(brightest) {}

  [[nodiscard]] std::vector<FilmSample> shade(RayCounter& tracer,
                                              CameraRays& camera) const override;
  [[nodiscard]] Development develop(const Film& film) const override;

 private:
  std::optional<double> brightest_;
};

}  // namespace planetree::render
