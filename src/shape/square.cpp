#include "shape/centered_ray.hpp"
#include "shape/outward.hpp"

#include <planetree/mesh/clip_triangle.hpp>
#include <planetree/shape/square.hpp>

#include <algorithm>
#include <cmath>

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
  /// Half the size of the box around it, along one axis.
  [[nodiscard]] double extent(Axis axis) const noexcept {
    return detail::sumRoundedUp(std::fabs(edgeU[axis]), std::fabs(edgeV[axis])) / 2.0;
  }
};

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
  const auto centered = detail::centeredRay(Vec3d(ray.origin) - exact.center, Vec3d(ray.direction));
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
