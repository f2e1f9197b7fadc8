#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/vec3.hpp>

namespace planetree {

/// A box around the part of the triangle inside the closed cell; empty if they do not touch. It is
/// never too small: computed in double from the triangle's own corners, with room for the rounding,
/// and rounded outward. It never leaves the cell nor the triangle's own box.
/// Sutherland and Hodgman, "Reentrant polygon clipping", CACM 1974.
template <class T>
[[nodiscard]] Box3 clippedTriangleBounds(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c,
                                         const Box3& cell) noexcept;

}  // namespace planetree
