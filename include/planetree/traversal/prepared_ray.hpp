#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/sheared_ray.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace planetree {

/// How far, in unit roundoffs of the largest distance D between the ray's origin and a corner of
/// the tree's bounds, the point at the t of an accepted hit may lie from the object that was hit,
/// plus the rounding of the plane tests themselves. Derived in docs/numerics.md: at most 12 for
/// float and 29 for double, rounded up.
template <class T>
inline constexpr T kSlackInRoundoffs = T(0);
template <>
inline constexpr float kSlackInRoundoffs<float> = 16.0f;
template <>
inline constexpr double kSlackInRoundoffs<double> = 32.0;

namespace detail {

template <class T>
inline constexpr T kRoundoff = std::numeric_limits<T>::epsilon() / T(2);

/// A component of a direction that is smaller than this part of the largest one counts as parallel
/// to the planes across its axis.
template <class T>
inline constexpr T kNearParallel = kRoundoff<T>* T(0x1p-16);

/// Along any axis, how far a corner of the box is from the point.
template <class T>
[[nodiscard]] T largestDistance(const Vec3<T>& point, const Box3& box) noexcept {
  T largest = T(0);
  for (const Axis axis : kAxes) {
    const T toLower = std::fabs(static_cast<T>(box.lower[axis]) - point[axis]);
    const T toUpper = std::fabs(static_cast<T>(box.upper[axis]) - point[axis]);
    largest = std::max({largest, toLower, toUpper});
  }
  return largest;
}

}  // namespace detail

/// A part of a ray.
template <class T>
struct Interval {
  T tMin;
  T tMax;

  /// True also if a bound is NaN.
  [[nodiscard]] constexpr bool isEmpty() const noexcept { return !(tMin <= tMax); }
};

/// A ray along one axis, as the planes across that axis see it.
template <class T>
struct AxisRay {
  T origin;
  T inverseDirection;  ///< always finite for a valid ray; see `awayFromParallel`
  T slack;             ///< how far t may be off where the ray meets a plane
  bool fromAbove;      ///< whether the ray meets planes from above

  /// Where the ray meets the plane; right to within `slack`.
  [[nodiscard]] T distanceToPlane(float position) const noexcept {
    return (static_cast<T>(position) - origin) * inverseDirection;
  }
};

/// A ray with what the split nodes of one tree need of it. Made once per query.
template <class T>
struct PreparedRay {
  ShearedRay<T> sheared;
  /// How far a hit may seem to lie from the object that was hit, along any axis.
  T distanceSlack;
  std::array<AxisRay<T>, 3> axes;

  PreparedRay(const Ray<T>& ray, const Box3& bounds) noexcept : sheared(ray) {
    distanceSlack =
        kSlackInRoundoffs<T> * detail::kRoundoff<T> * detail::largestDistance(ray.origin, bounds);
    for (const Axis axis : kAxes) {
      const T inverse = T(1) / awayFromParallel(ray.direction[axis]);
      axes[static_cast<std::size_t>(axis)] = {.origin = ray.origin[axis],
                                              .inverseDirection = inverse,
                                              .slack = distanceSlack * std::fabs(inverse),
                                              .fromAbove = std::signbit(inverse)};
    }
  }

  [[nodiscard]] const Ray<T>& ray() const noexcept { return sheared.ray; }

  [[nodiscard]] const AxisRay<T>& along(Axis axis) const noexcept {
    return axes[static_cast<std::size_t>(axis)];
  }

  /// False for rays that miss everything: a direction that is zero, or a NaN or infinity in the
  /// direction or the origin.
  [[nodiscard]] bool isValid() const noexcept {
    return isFinite(ray().origin) && isFinite(ray().direction) && largestComponent() != T(0);
  }

  /// Whether the ray runs so nearly along the planes across the axis that they all look parallel.
  [[nodiscard]] bool isNearlyParallel(Axis axis) const noexcept {
    return !(std::fabs(ray().direction[axis]) >= largestComponent() * detail::kNearParallel<T>);
  }

  /// The part of the interval in which the ray may be inside the box; a little too long, never too
  /// short. Only for boxes inside the bounds that the ray was prepared for.
  [[nodiscard]] Interval<T> clip(const Box3& box, Interval<T> interval) const noexcept {
    for (const Axis axis : kAxes) {
      const AxisRay<T>& ray = along(axis);
      const T toLower = ray.distanceToPlane(box.lower[axis]);
      const T toUpper = ray.distanceToPlane(box.upper[axis]);
      const T entry = (ray.fromAbove ? toUpper : toLower) - ray.slack;
      const T exit = (ray.fromAbove ? toLower : toUpper) + ray.slack;
      if (entry > interval.tMin)
        interval.tMin = entry;
      if (exit < interval.tMax)
        interval.tMax = exit;
    }
    return interval;
  }

 private:
  [[nodiscard]] T largestComponent() const noexcept {
    const Vec3<T>& direction = ray().direction;
    return std::max({std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z)});
  }

  /// A component that is zero, or so small against the largest one that the ray moves along the
  /// axis by less than the slack within the whole tree, is replaced by one just that small, of the
  /// same sign. Then no quotient is infinite or NaN, a ray that runs beside a plane meets it far
  /// outside every interval, and one within the slack of the plane visits both sides.
  [[nodiscard]] T awayFromParallel(T component) const noexcept {
    const T smallest = largestComponent() * detail::kNearParallel<T>;
    return std::copysign(std::max(std::fabs(component), smallest), component);
  }
};

}  // namespace planetree
