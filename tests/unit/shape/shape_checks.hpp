#pragma once

#include "unit/shape/reference_shapes.hpp"

#include <planetree/geometry/rounding.hpp>
#include <planetree/shape/shapes.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace planetree::test {

template <class T>
inline constexpr Real kUnitRoundoff = std::numeric_limits<T>::epsilon() / 2;

/// How many roundings of the distance a reported point may be off: what the tree relies on.
template <class T>
inline constexpr Real kAllowedRoundings = sizeof(T) == sizeof(float) ? 8 : 20;

/// The largest coordinate distance between the origin of a ray and the corners of a box.
template <class T>
[[nodiscard]] Real largestDistance(const Vec3<T>& origin, const Box3& box) {
  Real largest = 0;
  for (const Axis axis : kAxes) {
    const Real from = static_cast<Real>(origin[axis]);
    largest = std::max({largest, std::fabs(static_cast<Real>(box.lower[axis]) - from),
                        std::fabs(static_cast<Real>(box.upper[axis]) - from)});
  }
  return largest;
}

/// How far a point, relative to the anchor of the shape, is outside a box, along the axis where it
/// is farthest; negative inside.
template <class S>
[[nodiscard]] Real excess(const Box3& box, const S& shape, const Vec3l& point) {
  const Vec3l lower = Vec3l(box.lower) - anchor(shape);
  const Vec3l upper = Vec3l(box.upper) - anchor(shape);
  Real largest = -std::numeric_limits<Real>::infinity();
  for (const Axis axis : kAxes) {
    largest = std::max({largest, lower[axis] - point[axis], point[axis] - upper[axis]});
  }
  return largest;
}

/// One rounding of the largest distance that matters for the ray: the unit of all allowances.
template <class S, class T>
[[nodiscard]] Real roundingOf(const S& shape, const Ray<T>& ray) {
  return kUnitRoundoff<T> * largestDistance(ray.origin, shape.bounds());
}

struct DeepestPoint {
  Real level;
  Real t;
};

/// Where the whole line is deepest inside a solid, or comes closest to it: the least `level` along
/// the line, by golden section search.
template <class S, class T>
[[nodiscard]] DeepestPoint deepestPoint(const S& solid, const Ray<T>& ray) {
  constexpr int kSteps = 90;  // to below one rounding in double
  const Real ratio = (std::sqrt(Real(5)) - 1) / 2;
  const Real reach = 4 * largestDistance(ray.origin, solid.bounds()) / length(Vec3l(ray.direction));
  const auto at = [&](Real t) { return DeepestPoint{level(solid, pointAt(solid, ray, t)), t}; };
  Real from = -reach;
  Real to = reach;
  DeepestPoint left = at(to - ratio * (to - from));
  DeepestPoint right = at(from + ratio * (to - from));
  for (int i = 0; i < kSteps; ++i) {
    if (left.level < right.level) {
      to = right.t;
      right = left;
      left = at(to - ratio * (to - from));
    } else {
      from = left.t;
      left = right;
      right = at(from + ratio * (to - from));
    }
  }
  return left.level < right.level ? left : right;
}

/// Every hit along the ray, as a user finds them: by asking again behind the last one.
template <class S, class T = typename S::Scalar>
[[nodiscard]] std::vector<Hit<T>> allHits(const S& shape, const Ray<T>& ray,
                                          T tMin = -std::numeric_limits<T>::infinity()) {
  constexpr std::size_t kEnough = 8;
  std::vector<Hit<T>> hits;
  while (hits.size() < kEnough) {
    const auto hit = shape.intersect(ray, tMin, std::numeric_limits<T>::infinity());
    if (!hit)
      break;
    hits.push_back(*hit);
    tMin = nextUp(hit->t);
  }
  return hits;
}

}  // namespace planetree::test
