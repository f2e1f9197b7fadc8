#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/vec3.hpp>
#include <planetree/node/node.hpp>

#include <cstdint>
#include <functional>
#include <span>

namespace planetree::render {

/// One edge of a cell.
struct CellEdge {
  Vec3f a;
  Vec3f b;
};

/// Visits the edges of the cells at one depth of a tree, and of the leaves that lie above it. The
/// root's cell is at depth 1 and has the edges of the tree's bounds.
///
/// Cells share their edges. So that few are visited more than once, they come as the twelve edges
/// of the bounds and the four of the rectangle that each split above the depth cuts out of its
/// cell: where two walls of a cell meet, the later of the two splits was cut off by the earlier
/// one.
void forEachCellEdge(std::span<const Node> nodes, const Box3& bounds, std::uint32_t depth,
                     const std::function<void(const CellEdge&)>& visit);

}  // namespace planetree::render
