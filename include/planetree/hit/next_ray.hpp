#pragma once

#include <planetree/geometry/axis.hpp>
#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/traversal/prepared_ray.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace planetree {

/// The ray that goes on from a hit into `direction`: to a light, reflected, or refracted. It begins
/// at t = 0 and does not hit again the face that it leaves, although the point of a hit is rounded
/// and lies a little before or behind the surface: its origin is that point, moved along the normal
/// to the side that `direction` points to. No epsilon has to be chosen, and `tMin` may stay 0.
///
/// `hit` must be a hit of `ray` on an object of a tree with these bounds (`KdTree::bounds()`),
/// found without `QueryOptions::crossings`, which may change the normal; the direction is any that
/// a ray may have, and `tMax` of the result is infinite. Within the ranges of docs/limits.md a flat
/// face is never hit again, unless its corners lie on one line, so that it has no sides;
/// docs/numerics.md derives the bound. The distance is some tens of roundoffs of the lengths
/// involved: from the ray's origin to the far end of the bounds, from the hit to their far end, and
/// from zero to the hit. So it is small if the first ray began near. What lies closer to the
/// surface is not seen by the new ray. Where a surface curves toward the direction, as the inside
/// of a sphere does, it is hit again where it should be, maybe nearby.
///
/// Waechter and Binder, "A fast and robust method for avoiding self-intersection", Ray Tracing Gems
/// 2019, find the point by its weights and move it by a number of ulps that was chosen by trial;
/// Pharr, Jakob and Humphreys, "Physically based rendering", 3rd edition 2016, section 3.9, bound
/// the error of the point along each axis and move it out of that box, as here. In contrast to both
/// the distance also covers the error of the next ray's own test, needs no corners, and holds for
/// every shape that keeps the promise of object.hpp.
template <class T>
[[nodiscard]] Ray<T> nextRay(const Ray<T>& ray, const Hit<T>& hit, const Vec3<T>& direction,
                             const Box3& bounds) noexcept {
  // Of the point: that of t and direction, and of the two sums that the new origin comes from.
  constexpr T kRoundingsOfPoint = T(4);
  const Vec3<T> point = ray.at(hit.t);
  const T largest = std::max({std::fabs(point.x), std::fabs(point.y), std::fabs(point.z)});
  const T error =
      detail::kRoundoff<T> * (kSlackInRoundoffs<T> * (detail::largestDistance(ray.origin, bounds) +
                                                      detail::largestDistance(point, bounds)) +
                              kRoundingsOfPoint * largest);
  // Moving by this much along the normal leaves the box of the error behind, whatever its corner.
  const Vec3<T>& n = hit.normal;
  const T height = error * (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z));
  const bool leavesAtFront = !(dot(static_cast<Vec3d>(n), static_cast<Vec3d>(direction)) < 0.0);
  return {.origin = point + n * (leavesAtFront ? height : -height), .direction = direction};
}

}  // namespace planetree
