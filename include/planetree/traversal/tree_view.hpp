#pragma once

#include <planetree/detail/geometry_entry.hpp>
#include <planetree/geometry/box3.hpp>
#include <planetree/node/node.hpp>

#include <cstdint>
#include <span>

namespace planetree {

namespace detail {
struct WideTree;
}

/// What traversal reads: the arrays of a tree, which must outlive the view.
template <class T>
struct TreeView {
  std::span<const Node> nodes;
  std::span<const std::uint32_t> references;
  std::span<const detail::GeometryEntry<T>> geometries;
  Box3 bounds;
  const detail::WideTree* wide = nullptr;  ///< the same tree in the form made for speed, if any
};

}  // namespace planetree
