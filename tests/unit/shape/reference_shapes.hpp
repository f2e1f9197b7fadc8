#pragma once

#include <planetree/shape/shapes.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

/// The shapes once more, slowly and in long double, from their definition as sets of points: what
/// the library computes is held against these, never against itself.
///
/// `distance` is how far a point is from the surface. `level` of a solid is negative inside, zero
/// on the surface, positive outside, and convex along any line, so that its least value along a ray
/// says whether the ray hits. Inside it is minus the distance to the surface.
///
/// All points are relative to the anchor of the shape, lest long double itself rounds too much far
/// from the origin.
namespace planetree::test {

using Real = long double;
using Vec3l = Vec3<Real>;

template <class T>
[[nodiscard]] Vec3l anchor(const Sphere<T>& sphere) {
  return Vec3l(sphere.center);
}
template <class T>
[[nodiscard]] Vec3l anchor(const Box<T>& box) {
  return Vec3l(box.lower);
}
template <class T>
[[nodiscard]] Vec3l anchor(const Square<T>& square) {
  return Vec3l(square.center);
}
template <class T>
[[nodiscard]] Vec3l anchor(const Cone<T>& cone) {
  return Vec3l(cone.base);
}
template <class T>
[[nodiscard]] Vec3l anchor(const Cylinder<T>& cylinder) {
  return Vec3l(cylinder.base);
}
template <class T>
[[nodiscard]] Vec3l anchor(const Triangle<T>& triangle) {
  return Vec3l(triangle.a);
}

/// The point of the ray at t, relative to the anchor of the shape.
template <class S, class T>
[[nodiscard]] Vec3l pointAt(const S& shape, const Ray<T>& ray, Real t) {
  return (Vec3l(ray.origin) - anchor(shape)) + Vec3l(ray.direction) * t;
}

template <class T>
[[nodiscard]] Real level(const Sphere<T>& sphere, const Vec3l& point) {
  return length(point) - std::fabs(static_cast<Real>(sphere.radius));
}

template <class T>
[[nodiscard]] Real distance(const Sphere<T>& sphere, const Vec3l& point) {
  return std::fabs(level(sphere, point));
}

template <class T>
[[nodiscard]] Vec3l boxSize(const Box<T>& box) {
  return Vec3l(box.upper) - Vec3l(box.lower);
}

template <class T>
[[nodiscard]] Real level(const Box<T>& box, const Vec3l& point) {
  Real result = -std::numeric_limits<Real>::infinity();
  for (const Axis axis : kAxes) {
    result = std::max({result, -point[axis], point[axis] - boxSize(box)[axis]});
  }
  return result;
}

template <class T>
[[nodiscard]] Real distance(const Box<T>& box, const Vec3l& point) {
  Vec3l outside;
  for (const Axis axis : kAxes) {
    outside[axis] = std::max({-point[axis], point[axis] - boxSize(box)[axis], Real(0)});
  }
  const Real inside = level(box, point);
  return inside < 0 ? -inside : length(outside);
}

/// A point in the plane through the axis of a cone: the distance from the axis, the height.
struct Meridian {
  Real radius;
  Real height;
};

[[nodiscard]] inline Real distanceToSegment(const Meridian& from, const Meridian& to,
                                            const Meridian& point) {
  const Real dr = to.radius - from.radius;
  const Real dh = to.height - from.height;
  const Real lengthSquared = dr * dr + dh * dh;
  const Real along =
      ((point.radius - from.radius) * dr + (point.height - from.height) * dh) / lengthSquared;
  const Real clamped = lengthSquared > 0 ? std::clamp(along, Real(0), Real(1)) : Real(0);
  return std::hypot(point.radius - from.radius - clamped * dr,
                    point.height - from.height - clamped * dh);
}

template <class T>
struct ReferenceCone {
  Vec3l unitAxis;
  Real height;
  Real bottomRadius;
  Real topRadius;
  bool capped;

  explicit ReferenceCone(const Cone<T>& cone)
      : unitAxis(normalized(Vec3l(cone.axis))),
        height(length(Vec3l(cone.axis))),
        bottomRadius(std::fabs(static_cast<Real>(cone.bottomRadius))),
        topRadius(std::fabs(static_cast<Real>(cone.topRadius))),
        capped(cone.capped) {}

  [[nodiscard]] Meridian meridian(const Vec3l& point) const {
    return {length(cross(point, unitAxis)), dot(point, unitAxis)};
  }
  [[nodiscard]] Real sideDistance(const Vec3l& point) const {
    return distanceToSegment({bottomRadius, 0}, {topRadius, height}, meridian(point));
  }
};

template <class T>
[[nodiscard]] Real level(const Cone<T>& cone, const Vec3l& point) {
  const ReferenceCone<T> reference(cone);
  const auto [radius, height] = reference.meridian(point);
  const Real slope = (reference.topRadius - reference.bottomRadius) / reference.height;
  const Real side = (radius - reference.bottomRadius - slope * height) / std::hypot(Real(1), slope);
  return std::max({side, -height, height - reference.height});
}

template <class T>
[[nodiscard]] Real distance(const Cone<T>& cone, const Vec3l& point) {
  const ReferenceCone<T> reference(cone);
  const Meridian at = reference.meridian(point);
  Real nearest = reference.sideDistance(point);
  if (cone.capped) {
    const Real height = reference.height;
    nearest = std::min({nearest, distanceToSegment({0, 0}, {reference.bottomRadius, 0}, at),
                        distanceToSegment({0, height}, {reference.topRadius, height}, at)});
  }
  return nearest;
}

template <class T>
[[nodiscard]] Cone<T> asCone(const Cylinder<T>& cylinder) {
  return {cylinder.base, cylinder.axis, cylinder.radius, cylinder.radius, cylinder.capped};
}

template <class T>
[[nodiscard]] Real level(const Cylinder<T>& cylinder, const Vec3l& point) {
  return level(asCone(cylinder), point);
}

template <class T>
[[nodiscard]] Real distance(const Cylinder<T>& cylinder, const Vec3l& point) {
  return distance(asCone(cylinder), point);
}

/// How far a point is from the circles where side and caps meet.
template <class T>
[[nodiscard]] Real rimDistance(const Cone<T>& cone, const Vec3l& point) {
  const ReferenceCone<T> reference(cone);
  const auto [radius, height] = reference.meridian(point);
  return std::min(std::hypot(radius - reference.bottomRadius, height),
                  std::hypot(radius - reference.topRadius, height - reference.height));
}

template <class T>
[[nodiscard]] Real rimDistance(const Cylinder<T>& cylinder, const Vec3l& point) {
  return rimDistance(asCone(cylinder), point);
}

/// The weights of edgeU and edgeV, from -1/2 to 1/2 on the square, and the height above its plane.
template <class T>
[[nodiscard]] Vec3l squareCoordinates(const Square<T>& square, const Vec3l& point) {
  const Vec3l u(square.edgeU);
  const Vec3l v(square.edgeV);
  const Vec3l normal = cross(u, v);
  const Real areaSquared = dot(normal, normal);
  return {dot(cross(point, v), normal) / areaSquared, dot(cross(u, point), normal) / areaSquared,
          dot(point, normal) / std::sqrt(areaSquared)};
}

/// To the nearest point in the skewed coordinates of the square: never less than the distance.
template <class T>
[[nodiscard]] Real distance(const Square<T>& square, const Vec3l& point) {
  const Vec3l at = squareCoordinates(square, point);
  const Real u = std::clamp(at.x, Real(-0.5), Real(0.5));
  const Real v = std::clamp(at.y, Real(-0.5), Real(0.5));
  return length(point - Vec3l(square.edgeU) * u - Vec3l(square.edgeV) * v);
}

[[nodiscard]] inline Real distanceToEdge(const Vec3l& from, const Vec3l& to, const Vec3l& point) {
  const Vec3l edge = to - from;
  const Real along = std::clamp(dot(point - from, edge) / dot(edge, edge), Real(0), Real(1));
  return length(point - from - edge * along);
}

template <class T>
[[nodiscard]] Real distance(const Triangle<T>& triangle, const Vec3l& point) {
  const Vec3l a;
  const Vec3l b = Vec3l(triangle.b) - Vec3l(triangle.a);
  const Vec3l c = Vec3l(triangle.c) - Vec3l(triangle.a);
  const Vec3l normal = cross(b, c);
  const bool isAbove = dot(cross(point, c), normal) >= 0 && dot(cross(b, point), normal) >= 0 &&
                       dot(cross(c - b, point - b), normal) >= 0;
  if (isAbove)
    return std::fabs(dot(point, normal)) / length(normal);
  return std::min(
      {distanceToEdge(a, b, point), distanceToEdge(b, c, point), distanceToEdge(c, a, point)});
}

}  // namespace planetree::test
