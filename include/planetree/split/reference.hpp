#pragma once

#include <planetree/geometry/box3.hpp>

#include <cstdint>

namespace planetree {

/// One entry of an object in one cell, as split search sees it: a box and a few bits, never the
/// object. An object has one reference in each cell that it touches.
struct Reference {
  Box3 bounds;                  ///< of the object, or of its part inside the cell
  std::uint32_t object = 0;     ///< the tree's number of the object
  std::uint32_t leftSides = 0;  ///< bit i: the normal's component along axis i is negative

  [[nodiscard]] constexpr bool isPlanar(Axis axis) const noexcept {
    return bounds.lower[axis] == bounds.upper[axis];
  }
  /// The side that the sign of the normal gives to an object that lies in a plane.
  [[nodiscard]] constexpr bool belongsLeft(Axis axis) const noexcept {
    return (leftSides >> static_cast<unsigned>(axis) & 1u) != 0;
  }
};

static_assert(sizeof(Reference) == 32);

}  // namespace planetree
