#pragma once

#include <planetree/geometry/rounding.hpp>
#include <planetree/geometry/vec3.hpp>

#include <limits>

namespace planetree {

/// An axis-aligned, closed box. Always float, whatever the scalar of the objects inside: points in
/// double are rounded outward, so a box is never smaller than what it bounds.
/// A default-made box is empty (lower is +infinity, upper is -infinity) and grows by `extend`.
struct Box3 {
  Vec3f lower{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
              std::numeric_limits<float>::infinity()};
  Vec3f upper{-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
              -std::numeric_limits<float>::infinity()};

  friend constexpr bool operator==(const Box3&, const Box3&) noexcept = default;

  /// True if no point lies inside; also true if a corner is NaN.
  [[nodiscard]] constexpr bool isEmpty() const noexcept {
    return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z);
  }

  [[nodiscard]] constexpr Vec3f size() const noexcept { return upper - lower; }

  /// Surface area in double, so that neither huge nor tiny boxes over- or underflow. A flat box has
  /// the area of its two faces; an empty box has none.
  [[nodiscard]] constexpr double surfaceArea() const noexcept {
    if (isEmpty())
      return 0.0;
    const double x = static_cast<double>(upper.x) - static_cast<double>(lower.x);
    const double y = static_cast<double>(upper.y) - static_cast<double>(lower.y);
    const double z = static_cast<double>(upper.z) - static_cast<double>(lower.z);
    return 2.0 * (x * y + y * z + z * x);
  }

  constexpr void extend(const Vec3f& point) noexcept {
    // Choices, of which compilers make no branches.
    for (const Axis axis : kAxes) {
      lower[axis] = point[axis] < lower[axis] ? point[axis] : lower[axis];
      upper[axis] = point[axis] > upper[axis] ? point[axis] : upper[axis];
    }
  }
  void extend(const Vec3d& point) noexcept {
    extend(Vec3f{roundDown(point.x), roundDown(point.y), roundDown(point.z)});
    extend(Vec3f{roundUp(point.x), roundUp(point.y), roundUp(point.z)});
  }
  /// Extending by an empty box changes nothing.
  constexpr void extend(const Box3& box) noexcept {
    if (box.isEmpty())
      return;
    extend(box.lower);
    extend(box.upper);
  }
};

/// The part that both boxes share; empty if they do not touch.
[[nodiscard]] constexpr Box3 intersection(const Box3& a, const Box3& b) noexcept {
  Box3 shared;
  for (const Axis axis : kAxes) {
    shared.lower[axis] = a.lower[axis] > b.lower[axis] ? a.lower[axis] : b.lower[axis];
    shared.upper[axis] = a.upper[axis] < b.upper[axis] ? a.upper[axis] : b.upper[axis];
  }
  return shared;
}

/// The part of the box where the coordinate along the axis is at most `position`, which must lie
/// within the box.
[[nodiscard]] constexpr Box3 leftPart(const Box3& box, Axis axis, float position) noexcept {
  Box3 left = box;
  left.upper[axis] = position;
  return left;
}

/// The part of the box where the coordinate along the axis is at least `position`, which must lie
/// within the box.
[[nodiscard]] constexpr Box3 rightPart(const Box3& box, Axis axis, float position) noexcept {
  Box3 right = box;
  right.lower[axis] = position;
  return right;
}

/// True if every point of `inner` lies in `outer`. An empty box lies in every box.
[[nodiscard]] constexpr bool contains(const Box3& outer, const Box3& inner) noexcept {
  if (inner.isEmpty())
    return true;
  return intersection(outer, inner) == inner;
}

}  // namespace planetree
