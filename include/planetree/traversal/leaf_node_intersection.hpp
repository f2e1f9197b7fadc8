#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/node/leaf_node.hpp>
#include <planetree/traversal/tree_view.hpp>

namespace planetree {

/// The narrow phase: tests every object of a leaf. If one is hit with t in [tMin, tMax], before `i`
/// in the order of `isBefore`, the first such hit is put into `i` and the answer is true; else `i`
/// is left alone. The point may lie outside the leaf's cell: an object is tested as a whole.
template <class T>
bool findIntersection(const LeafNode& leaf, const TreeView<T>& tree, const Ray<T>& r, Hit<T>& i,
                      T tMin, T tMax) noexcept;

}  // namespace planetree
