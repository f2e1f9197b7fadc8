#pragma once

#include <planetree/geometry/axis.hpp>
#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>

#include <concepts>
#include <cstdint>
#include <optional>

namespace planetree {

template <std::floating_point T>
class TriangleMeshView;

/// One triangle of a mesh, as a tree holds it: the mesh's address and a face index, no copy of the
/// corners. It is a `Shape` (see object.hpp); a mesh is never one object of a tree, its faces are.
///
/// The vertex indices of the face must be in range for everything but `isUsable`.
template <std::floating_point T>
class Face {
 public:
  using Scalar = T;

  Face(const TriangleMeshView<T>& mesh, std::uint32_t index) noexcept
      : mesh_(&mesh), index_(index) {}

  [[nodiscard]] std::uint32_t index() const noexcept { return index_; }

  /// False if an index is out of range, or a corner is not finite or beyond the range of float:
  /// such a face cannot be hit.
  [[nodiscard]] bool isUsable() const noexcept;

  /// Empty if the face is not usable.
  [[nodiscard]] Box3 bounds() const noexcept;
  [[nodiscard]] Box3 clippedBounds(const Box3& cell) const noexcept;
  [[nodiscard]] int planarSide(Axis axis) const noexcept;
  /// Watertight; see triangle_intersection.hpp.
  [[nodiscard]] std::optional<Hit<T>> intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept;
  /// By the half-open edge rule of `QueryOptions::crossings`.
  [[nodiscard]] std::optional<Hit<T>> intersectCrossing(const Ray<T>& ray, T tMin,
                                                        T tMax) const noexcept;

 private:
  const TriangleMeshView<T>* mesh_;
  std::uint32_t index_;
};

extern template class Face<float>;
extern template class Face<double>;

}  // namespace planetree
