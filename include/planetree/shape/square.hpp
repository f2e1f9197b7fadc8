#pragma once

#include <planetree/object.hpp>

#include <concepts>
#include <optional>

namespace planetree {

/// A flat piece with two sides, the unit square in the plane z = 0 unless told otherwise. In
/// general a parallelogram: the points center + (u - 1/2) edgeU + (v - 1/2) edgeV for u and v in
/// [0, 1].
///
/// Parallel edges, or one of zero length, leave no surface: nothing hits it, and its box is empty.
/// If a member is not finite nothing hits it, and its box is NaN. A ray within the plane misses.
/// Squares laid edge to edge are not watertight where their corners round; a mesh is.
///
/// Hits: `u` and `v` as above; `part` is 0. The normal is that of edgeU x edgeV.
template <std::floating_point T>
struct Square {
  using Scalar = T;

  Vec3<T> center{};
  Vec3<T> edgeU{T(1), T(0), T(0)};
  Vec3<T> edgeV{T(0), T(1), T(0)};

  [[nodiscard]] Box3 bounds() const noexcept;
  [[nodiscard]] Box3 clippedBounds(const Box3& cell) const noexcept;
  [[nodiscard]] int planarSide(Axis axis) const noexcept;
  [[nodiscard]] std::optional<Hit<T>> intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept;

  friend constexpr bool operator==(const Square&, const Square&) noexcept = default;
};

extern template struct Square<float>;
extern template struct Square<double>;

}  // namespace planetree
