#include <planetree/shape/triangle.hpp>

#include <planetree/mesh/clip_triangle.hpp>

#include "mesh/triangle_hit.hpp"
#include "shape/outward.hpp"

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
  return detail::trianglePlanarSide(a, b, c, axis);
}

template <std::floating_point T>
std::optional<Hit<T>> Triangle<T>::intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept {
  if (!isFinite(*this) || hasRepeatedCorner(*this))
    return std::nullopt;
  return detail::findTriangleHit(ShearedRay<T>(ray), a, b, c, tMin, tMax);
}

template <std::floating_point T>
std::optional<Hit<T>> Triangle<T>::intersectCrossing(const Ray<T>& ray, T tMin,
                                                     T tMax) const noexcept {
  if (!isFinite(*this) || hasRepeatedCorner(*this))
    return std::nullopt;
  return detail::findTriangleCrossing(ShearedRay<T>(ray), a, b, c, tMin, tMax);
}

template struct Triangle<float>;
template struct Triangle<double>;

}  // namespace planetree
