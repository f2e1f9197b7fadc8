#pragma once

#include "render/point2.hpp"

#include <cstdint>
#include <optional>

namespace planetree::render {

/// Samples on a grid, as the `.ray` format has them: the first one in the lower left corner of its
/// pixel. The picture of a grid of one is that of one ray a pixel, without any randomness.
struct SampleGrid {
  std::uint32_t side = 1;  ///< of the grid in a pixel; at least 1

  /// Adaptive antialiasing: a pixel has one sample, the first, and all others only if that differs
  /// from one of the eight pixels around by more than this, in any channel. Unset, all have all.
  ///
  /// Whitted, "An improved illumination model for shaded display", CACM 1980, divides pixels
  /// further and further; here they are looked at once, so that what a pixel gets does not depend
  /// on more than its neighbours.
  std::optional<float> threshold = {};

  [[nodiscard]] std::uint32_t samplesPerPixel() const noexcept { return side * side; }
};

/// Where in a pixel the sample with this number lies, from its upper left corner.
[[nodiscard]] Point2 gridPoint(const SampleGrid& grid, std::uint32_t sample) noexcept;

}  // namespace planetree::render
