#pragma once

#include <planetree/object.hpp>

#include <concepts>
#include <optional>

namespace planetree {

/// The surface of an axis-aligned box, the cube of edge 1 around the origin unless told otherwise.
/// It may be flat along any axis. If `lower` exceeds `upper` along one, nothing hits the box, and
/// its bounds are empty. If a member is not finite nothing hits it, and its bounds are NaN.
/// (`Box3` is the box around an object; this is an object.)
///
/// A box is solid: a ray that enters leaves again, also along edges and through corners, and a ray
/// from inside hits the side where it leaves. Boxes that share a side, an edge or a corner let no
/// ray through between them.
///
/// Hits: `part` is 2 * axis for the side at `lower` and 2 * axis + 1 for the one at `upper`; `u`
/// and `v` in [0, 1] are the position on that side from lower to upper, along the two axes that
/// follow in the cycle x, y, z. On edges the lowest axis wins. The normal points away from the
/// inside.
template <std::floating_point T>
struct Box {
  using Scalar = T;

  Vec3<T> lower{T(-0.5), T(-0.5), T(-0.5)};
  Vec3<T> upper{T(0.5), T(0.5), T(0.5)};

  [[nodiscard]] Box3 bounds() const noexcept;
  /// Smaller than the box's part: a cell within the box holds none of its surface.
  [[nodiscard]] Box3 clippedBounds(const Box3& cell) const noexcept;
  [[nodiscard]] std::optional<Hit<T>> intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept;

  friend constexpr bool operator==(const Box&, const Box&) noexcept = default;
};

extern template struct Box<float>;
extern template struct Box<double>;

}  // namespace planetree
