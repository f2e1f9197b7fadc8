#pragma once

#include <planetree/geometry/box3.hpp>

#include <algorithm>
#include <cstdint>

namespace planetree {

/// Whether a scene keeps to the sizes within which no hit is lost; docs/limits.md says what may
/// happen outside of them.
enum class SceneRange : std::uint8_t {
  Within,
  TooSmall,  ///< the largest side of its box is shorter than `kSmallestExtent`
  TooLarge,  ///< the largest side of its box is longer than `kLargestExtent`
  TooFar,    ///< a coordinate is larger than `kLargestCoordinate`
};

inline constexpr float kSmallestExtent = 0x1p-30f;
inline constexpr float kLargestExtent = 0x1p30f;
inline constexpr float kLargestCoordinate = 0x1p30f;

/// Of a scene with these bounds; `Within` if there is nothing in it.
[[nodiscard]] constexpr SceneRange sceneRangeOf(const Box3& bounds) noexcept {
  if (bounds.isEmpty())
    return SceneRange::Within;
  // In double the sides of a box are finite and hardly rounded.
  double extent = 0.0;
  float coordinate = 0.0f;
  for (const Axis axis : kAxes) {
    extent = std::max(
        extent, static_cast<double>(bounds.upper[axis]) - static_cast<double>(bounds.lower[axis]));
    coordinate = std::max({coordinate, bounds.upper[axis], -bounds.lower[axis]});
  }
  if (extent < static_cast<double>(kSmallestExtent))
    return SceneRange::TooSmall;
  if (extent > static_cast<double>(kLargestExtent))
    return SceneRange::TooLarge;
  return coordinate > kLargestCoordinate ? SceneRange::TooFar : SceneRange::Within;
}

}  // namespace planetree
