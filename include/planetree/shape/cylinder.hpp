#pragma once

#include <planetree/object.hpp>
#include <planetree/shape/cone.hpp>

#include <concepts>
#include <optional>

namespace planetree {

/// A right circular cylinder, of radius 1 around z from z = 0 to 1 unless told otherwise. It is the
/// cone with two equal radii, and everything said there holds: degenerate members, caps, and what
/// `part`, `u` and `v` mean.
template <std::floating_point T>
struct Cylinder {
  using Scalar = T;

  Vec3<T> base{};
  Vec3<T> axis{T(0), T(0), T(1)};  ///< from the centre of the base to the centre of the top
  T radius = T(1);
  bool capped = true;

  /// The smallest box, but for rounding outward.
  [[nodiscard]] Box3 bounds() const noexcept;
  [[nodiscard]] std::optional<Hit<T>> intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept;

  friend constexpr bool operator==(const Cylinder&, const Cylinder&) noexcept = default;
};

extern template struct Cylinder<float>;
extern template struct Cylinder<double>;

}  // namespace planetree
