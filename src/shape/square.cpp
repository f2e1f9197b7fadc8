#include "mesh/triangle_hit.hpp"
#include "shape/centered_ray.hpp"
#include "shape/outward.hpp"

#include <planetree/mesh/clip_triangle.hpp>
#include <planetree/shape/square.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

namespace planetree {
namespace {

/// The same in double. The conversion is exact, so both scalars share one computation.
struct Parallelogram {
  Vec3d center;
  Vec3d edgeU;
  Vec3d edgeV;
  Vec3d normal;  ///< edgeU x edgeV: its length is the area
  double areaSquared;

  template <class T>
  explicit Parallelogram(const Square<T>& square) noexcept
      : center(square.center),
        edgeU(square.edgeU),
        edgeV(square.edgeV),
        normal(cross(edgeU, edgeV)),
        areaSquared(dot(normal, normal)) {}

  [[nodiscard]] bool hasSurface() const noexcept {
    return isFinite(center) && areaSquared > 0.0 && std::isfinite(areaSquared);
  }
  /// Whether the angle between the edges is too small for u and v to be as exact as object.hpp asks
  /// for: their error is that of rounding, divided by the sine.
  template <class T>
  [[nodiscard]] bool isNarrow() const noexcept {
    constexpr double kLeastSine = std::is_same_v<T, float> ? 0x1p-20 : 0.5;
    return areaSquared < kLeastSine * kLeastSine * dot(edgeU, edgeU) * dot(edgeV, edgeV);
  }
  /// Half the size of the box around it, along one axis.
  [[nodiscard]] double extent(Axis axis) const noexcept {
    return detail::sumRoundedUp(std::fabs(edgeU[axis]), std::fabs(edgeV[axis])) / 2.0;
  }
};

/// The hit wherever on the ray it is, from the two triangles that make up the parallelogram: their
/// test is exact for slivers, too. On the diagonal, which both have, the first one decides.
std::optional<Hit<double>> findHitOfNarrow(const Parallelogram& narrow, const Vec3d& origin,
                                           const Vec3d& direction) noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Vec3d halfU = narrow.edgeU / 2.0;
  const Vec3d halfV = narrow.edgeV / 2.0;
  const Vec3d lowerLeft = -halfU - halfV;
  const Vec3d upperRight = halfU + halfV;
  const ShearedRay<double> ray(Ray<double>{.origin = origin, .direction = direction});
  auto hit =
      detail::findTriangleHit(ray, lowerLeft, halfU - halfV, upperRight, -kInfinity, kInfinity);
  if (hit) {
    hit->u += hit->v;
  } else {
    hit = detail::findTriangleHit(ray, lowerLeft, upperRight, halfV - halfU, -kInfinity, kInfinity);
    if (hit)
      hit->v += hit->u;
  }
  return hit;
}

}  // namespace

template <std::floating_point T>
Box3 Square<T>::bounds() const noexcept {
  if (!isFinite(center) || !isFinite(edgeU) || !isFinite(edgeV))
    return detail::notFiniteBox();
  const Parallelogram exact(*this);
  if (!exact.hasSurface())
    return {};
  return detail::boxAround(exact.center,
                           {exact.extent(Axis::X), exact.extent(Axis::Y), exact.extent(Axis::Z)});
}

template <std::floating_point T>
Box3 Square<T>::clippedBounds(const Box3& cell) const noexcept {
  const Parallelogram exact(*this);
  if (!exact.hasSurface())
    return {};
  const Vec3d halfU = exact.edgeU / 2.0;
  const Vec3d halfV = exact.edgeV / 2.0;
  const Vec3d lowerLeft = exact.center - halfU - halfV;
  const Vec3d lowerRight = exact.center + halfU - halfV;
  const Vec3d upperLeft = exact.center - halfU + halfV;
  const Vec3d upperRight = exact.center + halfU + halfV;
  Box3 clipped = clippedTriangleBounds(lowerLeft, lowerRight, upperRight, cell);
  const Box3 otherHalf = clippedTriangleBounds(lowerLeft, upperRight, upperLeft, cell);
  if (clipped.isEmpty())
    return otherHalf;
  if (!otherHalf.isEmpty())
    clipped.extend(otherHalf);
  return clipped;
}

template <std::floating_point T>
int Square<T>::planarSide(Axis axis) const noexcept {
  const double component = Parallelogram(*this).normal[axis];
  return component < 0.0 ? -1 : component > 0.0 ? 1 : 0;
}

template <std::floating_point T>
std::optional<Hit<T>> Square<T>::intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept {
  const Parallelogram exact(*this);
  if (!exact.hasSurface())
    return std::nullopt;
  const Vec3d origin = Vec3d(ray.origin) - exact.center;
  if (exact.template isNarrow<T>()) {
    const auto hit = findHitOfNarrow(exact, origin, Vec3d(ray.direction));
    if (!hit || !detail::isWithin(static_cast<T>(hit->t), tMin, tMax))
      return std::nullopt;
    return Hit<T>{.t = static_cast<T>(hit->t),
                  .u = static_cast<T>(std::min(hit->u, 1.0)),
                  .v = static_cast<T>(std::min(hit->v, 1.0)),
                  .normal = Vec3<T>(hit->normal)};
  }
  const auto centered = detail::centeredRay(origin, Vec3d(ray.direction));
  if (!centered)
    return std::nullopt;

  // For a ray that grazes the plane s is far less certain than for a steep one. But u and v are
  // those of the point that has this very s, so a point that is reported lies within the edges; its
  // height above the plane is off by the error of s times the sine of the angle, which is small.
  const double approach = dot(exact.normal, centered->direction);
  if (approach == 0.0)
    return std::nullopt;
  const double s = -dot(exact.normal, centered->origin) / approach;
  const Vec3d point = centered->at(s);
  const double u = dot(cross(point, exact.edgeV), exact.normal) / exact.areaSquared;
  const double v = dot(cross(exact.edgeU, point), exact.normal) / exact.areaSquared;
  if (!(std::fabs(u) <= 0.5 && std::fabs(v) <= 0.5))
    return std::nullopt;

  const T t = centered->template rayParameter<T>(s);
  if (!detail::isWithin(t, tMin, tMax))
    return std::nullopt;
  Hit<T> hit;
  hit.t = t;
  hit.u = static_cast<T>(u + 0.5);
  hit.v = static_cast<T>(v + 0.5);
  hit.normal = Vec3<T>(normalized(exact.normal));
  return hit;
}

template struct Square<float>;
template struct Square<double>;

}  // namespace planetree
