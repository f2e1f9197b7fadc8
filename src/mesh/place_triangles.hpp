#pragma once

#include <planetree/detail/tree_data.hpp>

#include "node/widen_tree.hpp"

namespace planetree::detail {

/// Whether the objects of a geometry are faces that go into blocks.
[[nodiscard]] bool isTriangleMesh(const GeometryEntry<float>& geometry) noexcept;

/// Puts leaves that hold nothing but faces of meshes into blocks, unless they would take too many.
/// The tree must outlive the result.
[[nodiscard]] PlaceLeaf placeTriangles(const TreeData<float>& tree);

}  // namespace planetree::detail
