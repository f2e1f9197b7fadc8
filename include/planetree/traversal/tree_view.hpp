#pragma once

#include <planetree/detail/geometry_entry.hpp>
#include <planetree/geometry/box3.hpp>
#include <planetree/node/node.hpp>

#include <cstdint>
#include <span>

namespace planetree {

/// What traversal reads: the arrays of a tree, which must outlive the view.
template <class T>
struct TreeView {
  std::span<const Node> nodes;
  std::span<const std::uint32_t> references;
  std::span<const detail::GeometryEntry<T>> geometries;
  Box3 bounds;
};

}  // namespace planetree
