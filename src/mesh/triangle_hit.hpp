#pragma once

#include <planetree/hit/hit.hpp>
#include <planetree/mesh/triangle_intersection.hpp>

#include <cstdint>
#include <optional>

namespace planetree::detail {

/// What a shape made of one triangle answers: the hit with its normal, without ids.
template <class T>
[[nodiscard]] std::optional<Hit<T>> findTriangleHit(const ShearedRay<T>& ray, const Vec3<T>& a,
                                                    const Vec3<T>& b, const Vec3<T>& c, T tMin,
                                                    T tMax) noexcept {
  const auto found = intersectTriangle(ray, a, b, c, tMin, tMax);
  if (!found)
    return std::nullopt;
  return Hit<T>{.t = found->t,
                .u = found->u,
                .v = found->v,
                .normal = triangleNormal(a, b, c, ray.ray.direction)};
}

/// The same for a query with `QueryOptions::crossings`: the sides of all triangles must be those
/// that the edge functions saw, or they would not add up.
template <class T>
[[nodiscard]] std::optional<Hit<T>> findTriangleCrossing(const ShearedRay<T>& ray, const Vec3<T>& a,
                                                         const Vec3<T>& b, const Vec3<T>& c, T tMin,
                                                         T tMax) noexcept {
  const auto found = intersectTriangle(ray, a, b, c, tMin, tMax, EdgeRule::HalfOpen);
  if (!found)
    return std::nullopt;
  const Vec3<T>& direction = ray.ray.direction;
  Hit<T> hit{
      .t = found->t, .u = found->u, .v = found->v, .normal = triangleNormal(a, b, c, direction)};
  const T slope = dot(hit.normal, direction);
  if (!(found->isFromFront ? slope < T(0) : slope > T(0))) {
    const Vec3d along = normalized(static_cast<Vec3d>(direction));
    hit.normal = static_cast<Vec3<T>>(found->isFromFront ? -along : along);
  }
  return hit;
}

/// Bit i: the normal's component along axis i is negative. From the corners alone.
template <class T>
[[nodiscard]] std::uint32_t triangleLeftSides(const Vec3<T>& a, const Vec3<T>& b,
                                              const Vec3<T>& c) noexcept {
  const auto corner = static_cast<Vec3d>(a);
  const Vec3d normal = cross(static_cast<Vec3d>(b) - corner, static_cast<Vec3d>(c) - corner);
  return (normal.x < 0.0 ? 1u : 0u) | (normal.y < 0.0 ? 2u : 0u) | (normal.z < 0.0 ? 4u : 0u);
}

/// The sign of the normal's component along the axis, from the corners alone.
template <class T>
[[nodiscard]] int trianglePlanarSide(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c,
                                     Axis axis) noexcept {
  const auto corner = static_cast<Vec3d>(a);
  const double component =
      cross(static_cast<Vec3d>(b) - corner, static_cast<Vec3d>(c) - corner)[axis];
  return component < 0.0 ? -1 : component > 0.0 ? 1 : 0;
}

}  // namespace planetree::detail
