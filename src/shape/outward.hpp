#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/rounding.hpp>
#include <planetree/geometry/vec3.hpp>

#include <limits>

/// Boxes around computed coordinates that never cut the shape, and are exact where the coordinates
/// are: no margin is added without need, so a unit sphere has the bounds -1 and 1.
namespace planetree::detail {

/// What the sum a + b lost to rounding, exactly; NaN if the sum overflows.
/// Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B.
[[nodiscard]] inline double sumError(double a, double b, double sum) noexcept {
  const double bPart = sum - a;
  const double aPart = sum - bPart;
  return (a - aPart) + (b - bPart);
}

/// A double not above the exact a + b: the sum itself if it is exact.
[[nodiscard]] inline double sumRoundedDown(double a, double b) noexcept {
  const double sum = a + b;
  return sumError(a, b, sum) < 0.0 ? nextDown(sum) : sum;
}

/// A double not below the exact a + b: the sum itself if it is exact.
[[nodiscard]] inline double sumRoundedUp(double a, double b) noexcept {
  return -sumRoundedDown(-a, -b);
}

/// The box from center - extent to center + extent; the extents must not be negative.
[[nodiscard]] inline Box3 boxAround(const Vec3d& center, const Vec3d& extent) noexcept {
  Box3 box;
  for (const Axis axis : kAxes) {
    box.lower[axis] = roundDown(sumRoundedDown(center[axis], -extent[axis]));
    box.upper[axis] = roundUp(sumRoundedUp(center[axis], extent[axis]));
  }
  return box;
}

/// The bounds of a shape with a member that is not finite: they hold no point, and the tree reports
/// the shape as `SkipReason::NotFinite`.
[[nodiscard]] constexpr Box3 notFiniteBox() noexcept {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  return {.lower = {kNan, kNan, kNan}, .upper = {kNan, kNan, kNan}};
}

}  // namespace planetree::detail
