#pragma once

#include <planetree/geometry/axis.hpp>
#include <planetree/geometry/box3.hpp>

#include <cstdint>

namespace planetree {

/// Left is below a plane, right above it.
enum class Side : std::uint8_t { Left, Right };

/// A candidate for dividing a cell, with what it costs.
struct SplitPlane {
  Axis axis = Axis::X;
  float position = 0.0f;
  std::uint64_t leftCount = 0;   ///< objects in the left child
  std::uint64_t rightCount = 0;  ///< objects in the right child; straddling ones count in both
  Side planarSide =
      Side::Right;    ///< where objects in the plane go, under `PlanarRule::CheaperSide`
  double cost = 0.0;  ///< expected cost of a ray that meets the cell
};

/// The part of the cell below the plane, the plane included.
[[nodiscard]] constexpr Box3 calculateLeftBBox(const SplitPlane& plane, const Box3& cell) noexcept {
  return leftPart(cell, plane.axis, plane.position);
}

/// The part of the cell above the plane, the plane included.
[[nodiscard]] constexpr Box3 calculateRightBBox(const SplitPlane& plane,
                                                const Box3& cell) noexcept {
  return rightPart(cell, plane.axis, plane.position);
}

}  // namespace planetree
