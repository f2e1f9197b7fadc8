#pragma once

#include <planetree/object.hpp>

#include <concepts>
#include <optional>

namespace planetree {

/// A triangle on its own, with two sides. Many that share corners belong in a `TriangleMesh`, which
/// holds each corner once; both use the same watertight test (triangle_intersection.hpp), so
/// triangles that share an edge bit for bit let no ray through.
///
/// With two equal corners nothing hits it, and its box is empty. If a corner is not finite nothing
/// hits it, and its box is NaN.
///
/// Hits: `u` and `v` are the barycentric weights of b and c; `part` is 0. The normal points to
/// where a, b, c run counter-clockwise.
template <std::floating_point T>
struct Triangle {
  using Scalar = T;

  Vec3<T> a{};
  Vec3<T> b{T(1), T(0), T(0)};
  Vec3<T> c{T(0), T(1), T(0)};

  [[nodiscard]] Box3 bounds() const noexcept;
  [[nodiscard]] Box3 clippedBounds(const Box3& cell) const noexcept;
  [[nodiscard]] int planarSide(Axis axis) const noexcept;
  [[nodiscard]] std::optional<Hit<T>> intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept;
  [[nodiscard]] std::optional<Hit<T>> intersectCrossing(const Ray<T>& ray, T tMin,
                                                        T tMax) const noexcept;

  friend constexpr bool operator==(const Triangle&, const Triangle&) noexcept = default;
};

extern template struct Triangle<float>;
extern template struct Triangle<double>;

}  // namespace planetree
