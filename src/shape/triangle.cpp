#include "shape/outward.hpp"

#include <planetree/geometry/sheared_ray.hpp>
#include <planetree/mesh/clip_triangle.hpp>
#include <planetree/mesh/triangle_intersection.hpp>
#include <planetree/shape/triangle.hpp>

namespace planetree {
namespace {

template <class T>
[[nodiscard]] bool isFinite(const Triangle<T>& triangle) noexcept {
  return isFinite(triangle.a) && isFinite(triangle.b) && isFinite(triangle.c);
}

template <class T>
[[nodiscard]] bool hasRepeatedCorner(const Triangle<T>& triangle) noexcept {
  return triangle.a == triangle.b || triangle.b == triangle.c || triangle.c == triangle.a;
}

}  // namespace

template <std::floating_point T>
Box3 Triangle<T>::bounds() const noexcept {
  if (!isFinite(*this))
    return detail::notFiniteBox();
  if (hasRepeatedCorner(*this))
    return {};
  Box3 box;
  box.extend(a);
  box.extend(b);
  box.extend(c);
  return box;
}

template <std::floating_point T>
Box3 Triangle<T>::clippedBounds(const Box3& cell) const noexcept {
  if (!isFinite(*this) || hasRepeatedCorner(*this))
    return {};
  return clippedTriangleBounds(a, b, c, cell);
}

template <std::floating_point T>
int Triangle<T>::planarSide(Axis axis) const noexcept {
  const Vec3d corner(a);
  const double component = cross(Vec3d(b) - corner, Vec3d(c) - corner)[axis];
  return component < 0.0 ? -1 : component > 0.0 ? 1 : 0;
}

template <std::floating_point T>
std::optional<Hit<T>> Triangle<T>::intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept {
  if (!isFinite(*this) || hasRepeatedCorner(*this))
    return std::nullopt;
  const auto found = intersectTriangle(ShearedRay<T>(ray), a, b, c, tMin, tMax);
  if (!found)
    return std::nullopt;
  Hit<T> hit;
  hit.t = found->t;
  hit.u = found->u;
  hit.v = found->v;
  hit.normal = triangleNormal(a, b, c, ray.direction);
  return hit;
}

template struct Triangle<float>;
template struct Triangle<double>;

}  // namespace planetree
