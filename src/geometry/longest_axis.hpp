#pragma once

#include <planetree/geometry/axis.hpp>
#include <planetree/geometry/box3.hpp>

namespace planetree::detail {

/// The first of those along which the box is longest.
[[nodiscard]] constexpr Axis longestAxis(const Box3& box) noexcept {
  const Vec3f size = box.size();
  if (size.x >= size.y && size.x >= size.z)
    return Axis::X;
  return size.y >= size.z ? Axis::Y : Axis::Z;
}

}  // namespace planetree::detail
