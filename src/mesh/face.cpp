#include <planetree/mesh/clip_triangle.hpp>
#include <planetree/mesh/face.hpp>
#include <planetree/mesh/triangle_intersection.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <array>

namespace planetree {

template <std::floating_point T>
bool Face<T>::isUsable() const noexcept {
  for (const std::uint32_t vertex : mesh_->indices(index_)) {
    if (vertex >= mesh_->vertexCount() || !isFinite(static_cast<Vec3f>(mesh_->position(vertex)))) {
      return false;
    }
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
  const Vec3d corner = static_cast<Vec3d>(a);
  const Vec3d normal = cross(static_cast<Vec3d>(b) - corner, static_cast<Vec3d>(c) - corner);
  return normal[axis] < 0.0 ? -1 : normal[axis] > 0.0 ? 1 : 0;
}

template <std::floating_point T>
std::optional<Hit<T>> Face<T>::intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept {
  const auto [a, b, c] = mesh_->corners(index_);
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

template class Face<float>;
template class Face<double>;

}  // namespace planetree
