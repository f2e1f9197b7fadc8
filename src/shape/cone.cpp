#include "shape/centered_ray.hpp"
#include "shape/cone_side.hpp"
#include "shape/outward.hpp"

#include <planetree/shape/cone.hpp>

#include <array>
#include <cmath>
#include <cstdint>

namespace planetree {
namespace {

using detail::ConeFrame;
using detail::Interval;
using detail::LocalRay;

/// A crossing of the surface: the parameter of the moved ray, and what is crossed. The parameter is
/// infinite where there is no crossing.
struct Crossing {
  double s;
  std::uint32_t part;
};

/// Where the line is between the planes of the two caps.
[[nodiscard]] Interval slabInterval(const ConeFrame& frame, const LocalRay& ray) noexcept {
  const double rise = ray.direction.z;
  if (rise == 0.0) {
    return std::fabs(ray.origin.z) <= frame.halfHeight ? Interval{} : Interval::empty();
  }
  const double atBase = (-frame.halfHeight - ray.origin.z) / rise;
  const double atTop = (frame.halfHeight - ray.origin.z) / rise;
  return rise > 0.0 ? Interval{atBase, atTop} : Interval{atTop, atBase};
}

/// What is inside the side and inside the slab is the solid, so its two crossings are the later of
/// the entries and the earlier of the exits. Testing side and caps one by one would leak at the
/// rims, where each may say that the other is hit.
[[nodiscard]] std::array<Crossing, 2> solidCrossings(const ConeFrame& frame, const LocalRay& ray,
                                                     const Interval& side,
                                                     const Interval& slab) noexcept {
  // The rim of a flat cone is a sharp edge, and a rounding of the height alone would move it far
  // outward. The cylinder around the cone holds it in place.
  const Interval around =
      frame.sine == 0.0 ? side : detail::sideInterval(frame.cylinderAround(), ray, slab);
  const Interval tube = intersection(side, around);
  const bool isRising = ray.direction.z > 0.0;
  const Crossing entry = slab.entry > tube.entry
                             ? Crossing{slab.entry, isRising ? kBaseCapPart : kTopCapPart}
                             : Crossing{tube.entry, kSidePart};
  const Crossing exit = slab.exit < tube.exit
                            ? Crossing{slab.exit, isRising ? kTopCapPart : kBaseCapPart}
                            : Crossing{tube.exit, kSidePart};
  if (entry.s <= exit.s)
    return {entry, exit};
  return {Crossing{detail::kInfinity, kSidePart}, Crossing{detail::kInfinity, kSidePart}};
}

/// Without caps every crossing of the side counts by itself.
[[nodiscard]] std::array<Crossing, 2> openCrossings(const ConeFrame& frame, const LocalRay& ray,
                                                    const Interval& side) noexcept {
  const auto onSide = [&](double s) {
    const bool isHit = std::isfinite(s) && detail::isOnSide(frame, ray.at(s));
    return Crossing{isHit ? s : detail::kInfinity, kSidePart};
  };
  return {onSide(side.entry), onSide(side.exit)};
}

[[nodiscard]] double fraction(double part, double whole) noexcept {
  return whole > 0.0 ? std::fmin(std::fmax(part / whole, 0.0), 1.0) : 0.0;
}

template <class T>
[[nodiscard]] Hit<T> hitAt(const ConeFrame& frame, const Vec3d& point, T t,
                           std::uint32_t part) noexcept {
  const double radial = detail::axisDistance(point);
  Hit<T> hit;
  hit.t = t;
  hit.part = part;
  hit.u = static_cast<T>(detail::turnFraction(point.x, point.y));
  if (part == kSidePart) {
    hit.v = static_cast<T>(fraction(point.z + frame.halfHeight, 2.0 * frame.halfHeight));
    hit.normal = Vec3<T>(frame.toWorld(detail::sideNormal(frame, point)));
  } else {
    const bool isTop = part == kTopCapPart;
    hit.v = static_cast<T>(fraction(radial, isTop ? frame.topRadius : frame.bottomRadius));
    hit.normal = Vec3<T>(isTop ? frame.axis : -frame.axis);
  }
  return hit;
}

/// What the disc around the axis reaches along a coordinate axis, for a disc of radius 1: the sine
/// of the angle between both, not less than it really is.
[[nodiscard]] double discExtent(const Vec3d& axis, Axis along) noexcept {
  if (axis[along] == 0.0)
    return 1.0;
  Vec3d across = axis;
  across[along] = 0.0;
  // What the quotient, its root, and the caller's product with the radius may lose together.
  constexpr double kRoundingSlack = 1.0 + 8.0 * 0x1p-53;
  return std::fmin(std::sqrt(dot(across, across) / dot(axis, axis)) * kRoundingSlack, 1.0);
}

}  // namespace

template <std::floating_point T>
Box3 Cone<T>::bounds() const noexcept {
  if (!isFinite(base) || !isFinite(axis) || !std::isfinite(bottomRadius) ||
      !std::isfinite(topRadius)) {
    return detail::notFiniteBox();
  }
  const auto frame = detail::coneFrame(*this);
  if (!frame)
    return {};
  const Vec3d bottomCenter(base);
  const Vec3d topOffset(axis);
  Box3 box;
  for (const Axis along : kAxes) {
    const double extent = discExtent(frame->axis, along);
    const double bottom = frame->bottomRadius * extent;
    const double top = frame->topRadius * extent;
    const double topLower = detail::sumRoundedDown(bottomCenter[along], topOffset[along]);
    const double topUpper = detail::sumRoundedUp(bottomCenter[along], topOffset[along]);
    box.lower[along] = roundDown(std::fmin(detail::sumRoundedDown(bottomCenter[along], -bottom),
                                           detail::sumRoundedDown(topLower, -top)));
    box.upper[along] = roundUp(std::fmax(detail::sumRoundedUp(bottomCenter[along], bottom),
                                         detail::sumRoundedUp(topUpper, top)));
  }
  return box;
}

template <std::floating_point T>
std::optional<Hit<T>> Cone<T>::intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept {
  const auto frame = detail::coneFrame(*this);
  if (!frame)
    return std::nullopt;
  // The middle of the axis is never computed itself: it would be rounded at the size of `base`.
  const Vec3d fromMiddle = (Vec3d(ray.origin) - Vec3d(base)) - Vec3d(axis) / 2.0;
  const auto centered = detail::centeredRay(fromMiddle, Vec3d(ray.direction));
  if (!centered)
    return std::nullopt;
  const LocalRay local{frame->toLocal(centered->origin), frame->toLocal(centered->direction)};

  const Interval slab = slabInterval(*frame, local);
  if (slab.isEmpty())
    return std::nullopt;
  const Interval side = detail::sideInterval(*frame, local, slab);
  if (side.isEmpty())
    return std::nullopt;
  const auto crossings =
      capped ? solidCrossings(*frame, local, side, slab) : openCrossings(*frame, local, side);
  for (const Crossing& crossing : crossings) {
    const T t = centered->template rayParameter<T>(crossing.s);
    if (detail::isWithin(t, tMin, tMax)) {
      return hitAt(*frame, local.at(crossing.s), t, crossing.part);
    }
  }
  return std::nullopt;
}

template struct Cone<float>;
template struct Cone<double>;

}  // namespace planetree
