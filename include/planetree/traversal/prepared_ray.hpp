#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/sheared_ray.hpp>

#include <cmath>
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

/// A part of a ray.
template <class T>
struct Interval {
  T tMin;
  T tMax;

  /// True also if a bound is NaN.
  [[nodiscard]] constexpr bool isEmpty() const noexcept { return !(tMin <= tMax); }
};

/// A ray with what the split nodes of one tree need of it. Made once per query.
template <class T>
struct PreparedRay {
  ShearedRay<T> sheared;
  Vec3<T> inverseDirection;  ///< always finite for a valid ray; see `awayFromParallel`
  /// How far a hit may seem to lie from the object that was hit, along any axis.
  T distanceSlack;
  /// The same as a difference in t where the ray meets a plane across each axis.
  Vec3<T> slack;

  PreparedRay(const Ray<T>& ray, const Box3& bounds) noexcept : sheared(ray) {
    const T roundoff = std::numeric_limits<T>::epsilon() / T(2);
    distanceSlack = kSlackInRoundoffs<T> * roundoff * largestDistance(ray.origin, bounds);
    const T largest = std::fabs(ray.direction[sheared.kz]);
    for (const Axis axis : kAxes) {
      inverseDirection[axis] = T(1) / awayFromParallel(ray.direction[axis], largest);
      slack[axis] = distanceSlack * std::fabs(inverseDirection[axis]);
    }
  }

  [[nodiscard]] const Ray<T>& ray() const noexcept { return sheared.ray; }

  /// False for rays that miss everything: a direction that is zero, or a NaN or infinity in the
  /// direction or the origin.
  [[nodiscard]] bool isValid() const noexcept {
    return isFinite(ray().origin) && isFinite(ray().direction) &&
           ray().direction[sheared.kz] != T(0);
  }

  /// Whether the ray runs so nearly along the planes across the axis that they all look parallel.
  [[nodiscard]] bool isNearlyParallel(Axis axis) const noexcept {
    return !(std::fabs(ray().direction[axis]) >=
             std::fabs(ray().direction[sheared.kz]) * kNearParallel);
  }

  /// Whether the ray meets planes across the axis from above.
  [[nodiscard]] bool isNegative(Axis axis) const noexcept {
    return std::signbit(inverseDirection[axis]);
  }

  /// Where the ray meets the plane; right to within `slack[axis]`.
  [[nodiscard]] T distanceToPlane(Axis axis, float position) const noexcept {
    return (static_cast<T>(position) - ray().origin[axis]) * inverseDirection[axis];
  }

  /// The part of [tMin, tMax] in which the ray may be inside the box; a little too long, never too
  /// short. Only for boxes inside the bounds that the ray was prepared for.
  [[nodiscard]] Interval<T> clip(const Box3& box, Interval<T> interval) const noexcept {
    for (const Axis axis : kAxes) {
      const bool fromAbove = isNegative(axis);
      const T entry = distanceToPlane(axis, fromAbove ? box.upper[axis] : box.lower[axis]);
      const T exit = distanceToPlane(axis, fromAbove ? box.lower[axis] : box.upper[axis]);
      if (entry - slack[axis] > interval.tMin)
        interval.tMin = entry - slack[axis];
      if (exit + slack[axis] < interval.tMax)
        interval.tMax = exit + slack[axis];
    }
    return interval;
  }

 private:
  static constexpr T kNearParallel = T(0x1p-40);

  [[nodiscard]] static T largestDistance(const Vec3<T>& origin, const Box3& bounds) noexcept {
    T largest = T(0);
    for (const Axis axis : kAxes) {
      largest = std::fmax(largest, std::fabs(static_cast<T>(bounds.lower[axis]) - origin[axis]));
      largest = std::fmax(largest, std::fabs(static_cast<T>(bounds.upper[axis]) - origin[axis]));
    }
    return largest;
  }

  /// A component that is zero, or so small against the largest one that the ray moves along the
  /// axis by less than the slack within the whole tree, is replaced by one just that small, of the
  /// same sign. Then no quotient is infinite or NaN, a ray that runs beside a plane meets it far
  /// outside every interval, and one within the slack of the plane visits both sides.
  [[nodiscard]] static T awayFromParallel(T component, T largest) noexcept {
    const T smallest = largest * kNearParallel;
    return std::fabs(component) >= smallest ? component : std::copysign(smallest, component);
  }
};

}  // namespace planetree
