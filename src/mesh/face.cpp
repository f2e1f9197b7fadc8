#include <planetree/mesh/face.hpp>

#include <planetree/mesh/clip_triangle.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include "mesh/triangle_hit.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace planetree {
namespace {

/// Whether a float box can hold the point: a double just beyond the largest float would round to
/// it, but the box has to be rounded outward. False for NaN.
template <class T>
bool fitsIntoABox(const Vec3<T>& point) noexcept {
  constexpr auto kLargest = static_cast<T>(std::numeric_limits<float>::max());
  for (const Axis axis : kAxes) {
    if (!(std::fabs(point[axis]) <= kLargest))
      return false;
  }
  return true;
}

}  // namespace

template <std::floating_point T>
bool Face<T>::isUsable() const noexcept {
  for (const std::uint32_t vertex : mesh_->indices(index_)) {
    if (vertex >= mesh_->vertexCount() || !fitsIntoABox(mesh_->position(vertex)))
      return false;
  }
  return true;
}

template <std::floating_point T>
Box3 Face<T>::bounds() const noexcept {
  Box3 bounds;
  if (!isUsable())
    return bounds;
  for (const Vec3<T>& corner : mesh_->corners(index_))
    bounds.extend(corner);
  return bounds;
}

template <std::floating_point T>
Box3 Face<T>::clippedBounds(const Box3& cell) const noexcept {
  const auto [a, b, c] = mesh_->corners(index_);
  return clippedTriangleBounds(a, b, c, cell);
}

template <std::floating_point T>
int Face<T>::planarSide(Axis axis) const noexcept {
  const auto [a, b, c] = mesh_->corners(index_);
  return detail::trianglePlanarSide(a, b, c, axis);
}

template <std::floating_point T>
std::optional<Hit<T>> Face<T>::intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept {
  const auto [a, b, c] = mesh_->corners(index_);
  return detail::findTriangleHit(ShearedRay<T>(ray), a, b, c, tMin, tMax);
}

template <std::floating_point T>
std::optional<Hit<T>> Face<T>::intersectCrossing(const Ray<T>& ray, T tMin, T tMax) const noexcept {
  const auto [a, b, c] = mesh_->corners(index_);
  return detail::findTriangleCrossing(ShearedRay<T>(ray), a, b, c, tMin, tMax);
}

template class Face<float>;
template class Face<double>;

}  // namespace planetree
