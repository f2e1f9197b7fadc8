#pragma once

#include <planetree/object.hpp>

#include <concepts>
#include <optional>

namespace planetree {

/// The surface of a ball. A negative radius counts as positive; a sphere of radius zero has no
/// surface: nothing hits it, and its box is empty. If a member is not finite nothing hits it, and
/// its box is NaN.
///
/// Hits: `u` in [0, 1] is the longitude, from +x through +y, as a fraction of the full turn; `v` in
/// [0, 1] the latitude, from the pole at -z to the pole at +z, as a fraction of the half turn;
/// `part` is 0. The normal points away from the centre.
template <std::floating_point T>
struct Sphere {
  using Scalar = T;

  Vec3<T> center{};
  T radius = T(1);

  [[nodiscard]] Box3 bounds() const noexcept;
  /// Smaller than the box's part: neither a cell beside the ball nor one within it holds any of its
  /// surface.
  [[nodiscard]] Box3 clippedBounds(const Box3& cell) const noexcept;
  [[nodiscard]] std::optional<Hit<T>> intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept;

  friend constexpr bool operator==(const Sphere&, const Sphere&) noexcept = default;
};

extern template struct Sphere<float>;
extern template struct Sphere<double>;

}  // namespace planetree
