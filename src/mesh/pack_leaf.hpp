#pragma once

#include <planetree/detail/object_range.hpp>
#include <planetree/detail/tree_data.hpp>

#include "node/widen_tree.hpp"

namespace planetree::detail {

/// Whether the objects of a geometry are faces that go into blocks.
template <class T>
[[nodiscard]] bool isTriangleMesh(const GeometryEntry<T>& geometry) noexcept {
  return geometry.intersecting == &faceIntersectionTable<T>();
}

/// Packs leaves that hold nothing but faces of meshes, those of meshes in double as
/// `packRoundedTriangles` does; all others stay leaves of the binary form. The tree must outlive
/// the result.
template <class T>
[[nodiscard]] PackLeaf packTrianglesOf(const TreeData<T>& tree);
extern template PackLeaf packTrianglesOf(const TreeData<float>&);
extern template PackLeaf packTrianglesOf(const TreeData<double>&);

}  // namespace planetree::detail
