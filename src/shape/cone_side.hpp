#pragma once

#include <planetree/geometry/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

/// The curved side of a cone in its own coordinates: z along the axis, from the middle of the
/// height.
namespace planetree::detail {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The part of a line that is inside something convex.
struct Interval {
  double entry = -kInfinity;
  double exit = kInfinity;

  [[nodiscard]] static Interval empty() noexcept { return {kInfinity, -kInfinity}; }
  /// True also for NaN.
  [[nodiscard]] bool isEmpty() const noexcept { return !(entry <= exit); }
};

[[nodiscard]] inline Interval intersection(const Interval& a, const Interval& b) noexcept {
  return {std::fmax(a.entry, b.entry), std::fmin(a.exit, b.exit)};
}

struct LocalRay {
  Vec3d origin;
  Vec3d direction;

  [[nodiscard]] Vec3d at(double s) const noexcept { return origin + direction * s; }
};

/// A cone as its equations need it. The side is where the signed distance
///     cosine |(x, y)| - (cosine meanRadius + sine z)
/// is zero; `sine` and `cosine` are of the angle between side and axis, so that flat cones and long
/// needles are as well scaled as others. A cylinder has sine 0.
struct ConeFrame {
  Vec3d sideways;
  Vec3d upward;
  Vec3d axis;
  double halfHeight;
  double bottomRadius;
  double topRadius;
  double meanRadius;
  double sine;
  double cosine;

  [[nodiscard]] Vec3d toLocal(const Vec3d& v) const noexcept {
    return {dot(v, sideways), dot(v, upward), dot(v, axis)};
  }
  [[nodiscard]] Vec3d toWorld(const Vec3d& v) const noexcept {
    return sideways * v.x + upward * v.y + axis * v.z;
  }
  /// The cylinder that the wider of the two caps makes.
  [[nodiscard]] ConeFrame cylinderAround() const noexcept {
    ConeFrame cylinder = *this;
    cylinder.meanRadius = std::fmax(bottomRadius, topRadius);
    cylinder.sine = 0.0;
    cylinder.cosine = 1.0;
    return cylinder;
  }
  /// cosine times the radius at the height z: negative beyond the apex.
  [[nodiscard]] double scaledRadius(double z) const noexcept {
    return cosine * meanRadius + sine * z;
  }
};

[[nodiscard]] inline double axisDistance(const Vec3d& point) noexcept {
  return std::sqrt(point.x * point.x + point.y * point.y);
}

/// Fills in two unit vectors that make the unit vector `axis` a right-handed basis, exact for the
/// coordinate axes. Duff et al., "Building an orthonormal basis, revisited", JCGT 2017.
inline void completeBasis(ConeFrame& frame) noexcept {
  const Vec3d& n = frame.axis;
  const double sign = std::copysign(1.0, n.z);
  const double a = -1.0 / (sign + n.z);
  const double b = n.x * n.y * a;
  frame.sideways = {1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  frame.upward = {b, sign + n.y * n.y * a, -n.y};
}

/// Nothing for a cone without surface or with members that are not finite.
template <class Cone>
[[nodiscard]] std::optional<ConeFrame> coneFrame(const Cone& cone) noexcept {
  const Vec3d axis(cone.axis);
  ConeFrame frame;
  frame.axis = normalized(axis);
  frame.bottomRadius = std::fabs(static_cast<double>(cone.bottomRadius));
  frame.topRadius = std::fabs(static_cast<double>(cone.topRadius));
  frame.meanRadius = (frame.bottomRadius + frame.topRadius) / 2.0;
  const double height = dot(axis, frame.axis);
  if (!(height > 0.0 && frame.meanRadius > 0.0))
    return std::nullopt;
  if (!std::isfinite(height) || !std::isfinite(frame.meanRadius))
    return std::nullopt;
  frame.halfHeight = height / 2.0;
  completeBasis(frame);
  const Vec3d slant = normalized(Vec3d{height, frame.topRadius - frame.bottomRadius, 0.0});
  frame.cosine = slant.x;
  frame.sine = slant.y;
  return frame;
}

/// True if a point of the double cone lies on the side, between the rims: by its place along the
/// slanted line from base to top, which tells the rims of flat and of steep cones equally well.
[[nodiscard]] inline bool isOnSide(const ConeFrame& frame, const Vec3d& point) noexcept {
  const double place =
      frame.cosine * point.z + frame.sine * (axisDistance(point) - frame.meanRadius);
  const double halfLength =
      frame.cosine * frame.halfHeight + frame.sine * (frame.topRadius - frame.bottomRadius) / 2.0;
  // The other nappe has negative radii. So may the apex, by what the computation of z and of the
  // radius loses on numbers no larger than the cone; a ray through the apex must not be lost.
  constexpr double kRoundings = 10.0 * 0x1p-53;
  const double slack =
      kRoundings * (frame.cosine * frame.meanRadius + std::fabs(frame.sine) * frame.halfHeight);
  return std::fabs(place) <= halfLength && frame.scaledRadius(point.z) >= -slack;
}

/// The unit normal at a point of the side. At the apex, where there is none, it is along the axis.
[[nodiscard]] inline Vec3d sideNormal(const ConeFrame& frame, const Vec3d& point) noexcept {
  const double distance = axisDistance(point);
  if (distance == 0.0)
    return {0.0, 0.0, frame.sine > 0.0 ? -1.0 : 1.0};
  return {frame.cosine * point.x / distance, frame.cosine * point.y / distance, -frame.sine};
}

/// With s counted from some point of the ray, the line is inside the double cone where
/// a s^2 + 2 b s + c <= 0.
struct SideEquation {
  double a;
  double b;
  double c;
  double radius;    ///< the scaled radius at the point
  double widening;  ///< how it grows with s
};

[[nodiscard]] inline SideEquation sideEquation(const ConeFrame& frame, const Vec3d& point,
                                               const Vec3d& direction) noexcept {
  const double distance = frame.cosine * axisDistance(point);
  const double radius = frame.scaledRadius(point.z);
  const double across = frame.cosine * axisDistance(direction);
  const double widening = frame.sine * direction.z;
  return {.a = (across - widening) * (across + widening),
          .b = frame.cosine * frame.cosine * (point.x * direction.x + point.y * direction.y) -
               widening * radius,
          .c = (distance - radius) * (distance + radius),
          .radius = radius,
          .widening = widening};
}

/// The sum or difference of both that does not cancel. Not by std::copysign: the sign of a zero
/// must not matter.
[[nodiscard]] inline double awayFromZero(double b, double root) noexcept {
  return b < 0.0 ? b - root : b + root;
}

/// The solution in the nappe with positive radius.
[[nodiscard]] inline Interval insideInterval(const SideEquation& side) noexcept {
  const auto [a, b, c, radius, widening] = side;
  if (a == 0.0) {
    if (b == 0.0)
      return c <= 0.0 ? Interval{} : Interval::empty();
    const double root = -c / (2.0 * b);
    return b > 0.0 ? Interval{-kInfinity, root} : Interval{root, kInfinity};
  }
  const double discriminant = b * b - a * c;
  if (a > 0.0 && !(discriminant >= 0.0))
    return Interval::empty();
  // A line steeper than the side always meets the cone: a negative discriminant is rounding.
  const double q = -awayFromZero(b, std::sqrt(std::fmax(discriminant, 0.0)));
  const double largerRoot = q / a;
  const double smallerRoot = q == 0.0 ? 0.0 : c / q;
  const auto [earlier, later] = std::minmax(largerRoot, smallerRoot);
  if (a < 0.0) {
    // It comes from one nappe and goes into the other.
    return widening > 0.0 ? Interval{later, kInfinity} : Interval{-kInfinity, earlier};
  }
  const bool isOtherNappe = radius + widening * smallerRoot < 0.0;
  return isOtherNappe ? Interval::empty() : Interval{earlier, later};
}

/// The point of the ray, within the slab, that is closest to the axis.
[[nodiscard]] inline double closestToAxis(const LocalRay& ray, const Interval& slab) noexcept {
  const Vec3d& o = ray.origin;
  const Vec3d& d = ray.direction;
  const double across = d.x * d.x + d.y * d.y;
  const double closest = across > 0.0 ? -(o.x * d.x + o.y * d.y) / across : 0.0;
  return std::fmin(std::fmax(closest, slab.entry), slab.exit);
}

/// The root `s` again, solved from the point that it gives, where what is left is small. Near the
/// apex the first solution, made at the scale of the cone, has but half of its digits.
[[nodiscard]] inline double refinedRoot(const ConeFrame& frame, const LocalRay& ray,
                                        double s) noexcept {
  if (!std::isfinite(s))
    return s;
  const SideEquation rest = sideEquation(frame, ray.at(s), ray.direction);
  const double discriminant = rest.b * rest.b - rest.a * rest.c;
  // A negative discriminant is rounding where both roots are one: through the apex, or tangent.
  const double step = discriminant > 0.0 ? -rest.c / awayFromZero(rest.b, std::sqrt(discriminant))
                                         : -rest.b / rest.a;
  return std::isfinite(step) ? s + step : s;
}

/// Where the line is inside the cone of the frame and within the slab between its caps; exact only
/// as far as that.
///
/// The equation is set up at the point closest to the axis. If the side is hit within the slab at
/// all, that point is no farther from the axis than the side is, so the coefficients are right to a
/// few roundings of the radius, however long the cone is and however flat the ray. An error of the
/// direction turns the whole line, but within the slab moves no point by more than a few roundings
/// of the cone's size.
[[nodiscard]] inline Interval sideInterval(const ConeFrame& frame, const LocalRay& ray,
                                           const Interval& slab) noexcept {
  const double reference = closestToAxis(ray, slab);
  // Nowhere in the slab is the line closer to the axis than there. This also turns away lines whose
  // direction along the axis is nothing but rounding, and which meet the slab far off.
  constexpr double kRoundings = 0x1p-40;
  const double widest = std::fmax(frame.bottomRadius, frame.topRadius);
  if (axisDistance(ray.at(reference)) > widest + kRoundings * (widest + frame.halfHeight))
    return Interval::empty();
  const SideEquation equation = sideEquation(frame, ray.at(reference), ray.direction);
  const Interval inside = insideInterval(equation);
  if (inside.isEmpty())
    return Interval::empty();
  const Interval side{reference + inside.entry, reference + inside.exit};
  if (frame.sine == 0.0)
    return side;
  const double first = refinedRoot(frame, ray, side.entry);
  const double last = refinedRoot(frame, ray, side.exit);
  return {std::fmin(first, last), std::fmax(first, last)};
}

}  // namespace planetree::detail
