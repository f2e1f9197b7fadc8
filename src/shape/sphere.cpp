#include "shape/centered_ray.hpp"
#include "shape/outward.hpp"

#include <planetree/shape/sphere.hpp>

#include <cmath>

namespace planetree {
namespace {

[[nodiscard]] double lengthSquared(const Vec3d& v) noexcept {
  return dot(v, v);
}

/// The distances along each axis from a point to the nearest and to the farthest point of a cell.
struct CellDistances {
  Vec3d nearest;
  Vec3d farthest;

  CellDistances(const Box3& cell, const Vec3d& point) noexcept {
    for (const Axis axis : kAxes) {
      const double below = static_cast<double>(cell.lower[axis]) - point[axis];
      const double above = static_cast<double>(cell.upper[axis]) - point[axis];
      nearest[axis] = std::fmax(std::fmax(below, -above), 0.0);
      farthest[axis] = std::fmax(std::fabs(below), std::fabs(above));
    }
  }
};

template <class T>
[[nodiscard]] Hit<T> hitOnUnitSphere(T t, const Vec3d& normal) noexcept {
  constexpr double kHalfTurn = 3.141592653589793;
  // atan2 instead of acos: exact to a few ulp also at the poles.
  const double equatorDistance = std::sqrt(normal.x * normal.x + normal.y * normal.y);
  const double latitude = std::atan2(equatorDistance, -normal.z);
  Hit<T> hit;
  hit.t = t;
  hit.u = static_cast<T>(detail::turnFraction(normal.x, normal.y));
  hit.v = static_cast<T>(latitude / kHalfTurn);
  hit.normal = Vec3<T>(normal);
  return hit;
}

}  // namespace

template <std::floating_point T>
Box3 Sphere<T>::bounds() const noexcept {
  if (!isFinite(center) || !std::isfinite(radius))
    return detail::notFiniteBox();
  if (radius == T(0))
    return {};
  const double extent = std::fabs(static_cast<double>(radius));
  return detail::boxAround(Vec3d(center), {extent, extent, extent});
}

template <std::floating_point T>
Box3 Sphere<T>::clippedBounds(const Box3& cell) const noexcept {
  const Box3 whole = bounds();
  if (whole.isEmpty() || intersection(whole, cell).isEmpty())
    return {};
  const double radiusSquared = static_cast<double>(radius) * static_cast<double>(radius);
  // Each squared distance that matters is at most the squared radius: this covers what their sum
  // and its root lose.
  const double slack = radiusSquared * 16.0 * 0x1p-53;
  const CellDistances distances(cell, Vec3d(center));
  if (lengthSquared(distances.farthest) < radiusSquared - slack)
    return {};

  Vec3d extent;
  for (const Axis axis : kAxes) {
    Vec3d across = distances.nearest;
    across[axis] = 0.0;
    const double extentSquared = radiusSquared + slack - lengthSquared(across);
    if (extentSquared < 0.0)
      return {};
    extent[axis] = std::sqrt(extentSquared);
  }
  return intersection(detail::boxAround(Vec3d(center), extent), intersection(whole, cell));
}

template <std::floating_point T>
std::optional<Hit<T>> Sphere<T>::intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept {
  const double r = std::fabs(static_cast<double>(radius));
  if (!(r > 0.0) || !std::isfinite(r))
    return std::nullopt;
  const auto centered =
      detail::centeredRay(Vec3d(ray.origin) - Vec3d(center), Vec3d(ray.direction));
  if (!centered)
    return std::nullopt;

  // By Pythagoras the crossings lie half a chord before and behind the closest point. Computed from
  // a point that is off by e, they are off the sphere by about e at most, also where the ray only
  // grazes it: there the chord changes much, but along the surface.
  const double directionSquared = dot(centered->direction, centered->direction);
  const double chordSquared = r * r - dot(centered->origin, centered->origin);
  if (!(chordSquared >= 0.0))
    return std::nullopt;
  const double halfChord = std::sqrt(chordSquared / directionSquared);
  // What rounding left between the moved origin and the closest point.
  const double middle = -dot(centered->origin, centered->direction) / directionSquared;

  for (const double s : {middle - halfChord, middle + halfChord}) {
    const T t = centered->template rayParameter<T>(s);
    if (detail::isWithin(t, tMin, tMax))
      return hitOnUnitSphere(t, normalized(centered->at(s)));
  }
  return std::nullopt;
}

template struct Sphere<float>;
template struct Sphere<double>;

}  // namespace planetree
