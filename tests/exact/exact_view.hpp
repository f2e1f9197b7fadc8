#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/geometry/vec3.hpp>

#include "exact/ray_axes.hpp"

// CGAL's own headers bring warnings that are not ours to mend; the build marks them as the
// system's.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

/// Geometry without rounding, in the plane that a ray sees.
namespace planetree::test::exact {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;

/// A point as the ray sees it: the ray runs along the third axis and starts at the origin.
using Point = std::array<Number, 3>;
using Polygon = std::vector<Point>;

/// A ray and what its view of a corner takes, without rounding.
class View {
 public:
  explicit View(const Rayd& ray)
      : ray_(ray),
        axes_(ray.direction),
        directionZ_(ray.direction[axes_.z]),
        shearX_(Number(ray.direction[axes_.x]) / directionZ_),
        shearY_(Number(ray.direction[axes_.y]) / directionZ_) {}

  [[nodiscard]] Point of(const Vec3d& corner) const {
    const auto along = [&](Axis axis) { return Number(corner[axis]) - Number(ray_.origin[axis]); };
    const Number z = along(axes_.z);
    return {along(axes_.x) - shearX_ * z, along(axes_.y) - shearY_ * z, z};
  }
  [[nodiscard]] const Number& directionZ() const noexcept { return directionZ_; }

 private:
  const Rayd& ray_;
  RayAxes axes_;
  Number directionZ_;
  Number shearX_;
  Number shearY_;
};

/// What of the polygon lies where `sign * coordinate <= limit`. Sutherland and Hodgman, "Reentrant
/// polygon clipping", Communications of the ACM 1974; right for polygons without area, too, as
/// nothing is rounded.
[[nodiscard]] inline Polygon clipped(const Polygon& polygon, std::size_t axis, int sign,
                                     const Number& limit) {
  const auto beyond = [&](const Point& p) { return sign > 0 ? p[axis] - limit : -p[axis] - limit; };
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& p = polygon[i];
    const Point& q = polygon[(i + 1) % polygon.size()];
    const Number ofP = beyond(p);
    const Number ofQ = beyond(q);
    if (ofP <= 0)
      kept.push_back(p);
    if ((ofP < 0 && ofQ > 0) || (ofP > 0 && ofQ < 0)) {
      const Number part = ofP / (ofP - ofQ);
      Point between;
      for (std::size_t k = 0; k < 3; ++k)
        between[k] = p[k] + (q[k] - p[k]) * part;
      between[axis] = sign > 0 ? limit : -limit;
      kept.push_back(between);
    }
  }
  return kept;
}

/// What of the polygon has its first `axes` coordinates between -limit and limit.
[[nodiscard]] inline Polygon clippedToBox(Polygon polygon, std::size_t axes, const Number& limit) {
  for (std::size_t axis = 0; axis < axes; ++axis) {
    polygon = clipped(polygon, axis, 1, limit);
    polygon = clipped(polygon, axis, -1, limit);
  }
  return polygon;
}

/// The interval of t over points of a polygon, and `margin` more along z to both sides.
[[nodiscard]] inline std::pair<Number, Number> intervalOfT(const Polygon& polygon,
                                                           const Number& directionZ,
                                                           const Number& margin) {
  Number lower = polygon.front()[2] / directionZ;
  Number upper = lower;
  for (const Point& point : polygon) {
    const Number t = point[2] / directionZ;
    lower = std::min(lower, t);
    upper = std::max(upper, t);
  }
  const Number more = margin / CGAL::abs(directionZ);
  return {lower - more, upper + more};
}

/// Twice the signed area of the sheared triangle of the ray and the edge.
[[nodiscard]] inline Number edgeFunction(const Point& p, const Point& q) {
  return p[0] * q[1] - p[1] * q[0];
}

/// The distance between the ray and the edge in the sheared plane: the least, over the edge, of
/// the larger of |x| and |y|. That is convex, and linear between the places where one of them is
/// zero or both are equal.
[[nodiscard]] inline Number distanceToEdge(const Point& p, const Point& q) {
  const auto size = [](const Number& x, const Number& y) {
    return std::max(CGAL::abs(x), CGAL::abs(y));
  };
  Number least = std::min(size(p[0], p[1]), size(q[0], q[1]));
  const auto tryZeroOf = [&](const Number& atP, const Number& atQ) {
    if (!((atP < 0 && atQ > 0) || (atP > 0 && atQ < 0)))
      return;
    const Number part = atP / (atP - atQ);
    least = std::min(least, size(p[0] + (q[0] - p[0]) * part, p[1] + (q[1] - p[1]) * part));
  };
  tryZeroOf(p[0], q[0]);
  tryZeroOf(p[1], q[1]);
  tryZeroOf(p[0] - p[1], q[0] - q[1]);
  tryZeroOf(p[0] + p[1], q[0] + q[1]);
  return least;
}

/// The side on which the point (e, e^2), for e that tends to zero, sees the edge.
[[nodiscard]] inline int sideOfEdge(const Point& p, const Point& q) {
  if (const CGAL::Sign sign = CGAL::sign(edgeFunction(p, q)); sign != CGAL::ZERO)
    return sign;
  if (const CGAL::Sign sign = CGAL::sign(p[1] - q[1]); sign != CGAL::ZERO)
    return sign;
  return CGAL::sign(q[0] - p[0]);
}

/// How often the triangle winds around the ray, seen against z: 1, 0 or -1.
[[nodiscard]] inline int windingAlongZ(const std::array<Point, 3>& corners) {
  const int side = sideOfEdge(corners[0], corners[1]);
  return side == sideOfEdge(corners[1], corners[2]) && side == sideOfEdge(corners[2], corners[0])
             ? side
             : 0;
}

}  // namespace planetree::test::exact
