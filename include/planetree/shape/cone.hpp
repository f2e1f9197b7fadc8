#pragma once

#include <planetree/object.hpp>

#include <concepts>
#include <cstdint>
#include <optional>

namespace planetree {

/// The parts of cylinders and cones, as `Hit::part` names them.
inline constexpr std::uint32_t kSidePart = 0;
inline constexpr std::uint32_t kBaseCapPart = 1;
inline constexpr std::uint32_t kTopCapPart = 2;

/// A right circular cone, pointed or cut off: the radius goes from `bottomRadius` at `base` to
/// `topRadius` at `base + axis`. The members default to height and bottom radius 1, around z.
/// Negative radii count as positive. A cone whose axis or whose radii are all zero has no surface:
/// nothing hits it, and its box is empty. If a member is not finite nothing hits it, and its box is
/// NaN.
///
/// With caps it is solid: a ray that enters leaves again, also at the rims and the apex, and a ray
/// from inside hits where it leaves. Without caps it is the side alone, and a ray may pass through
/// the open ends. A ray that runs within the side does not hit the side.
///
/// Hits: `part` is `kSidePart` or one of the caps. `u` in [0, 1] is the angle around the axis as a
/// fraction of the full turn; it is counted counter-clockwise as seen from the top, and from +x
/// through +y if the axis is along +z (other axes: from a fixed perpendicular direction). `v` in
/// [0, 1] is, on the side, the height from base to top; on a cap, the distance from its centre over
/// its radius. The normal points away from the inside.
template <std::floating_point T>
struct Cone {
  using Scalar = T;

  Vec3<T> base{};
  Vec3<T> axis{T(0), T(0), T(1)};  ///< from the centre of the base to the centre of the top
  T bottomRadius = T(1);
  T topRadius = T(0);
  bool capped = true;

  /// The smallest box, but for rounding outward.
  [[nodiscard]] Box3 bounds() const noexcept;
  [[nodiscard]] std::optional<Hit<T>> intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept;

  friend constexpr bool operator==(const Cone&, const Cone&) noexcept = default;
};

extern template struct Cone<float>;
extern template struct Cone<double>;

}  // namespace planetree
