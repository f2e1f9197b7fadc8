#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/node/node.hpp>
#include <planetree/split/cost_model.hpp>

#include <cstdint>
#include <span>

namespace planetree {

/// A tree in numbers.
struct TreeStatistics {
  std::uint64_t splitNodeCount = 0;
  std::uint64_t leafNodeCount = 0;  ///< the empty ones included
  std::uint64_t emptyLeafCount = 0;
  std::uint64_t referenceCount = 0;  ///< entries of all leaves; an object may have several
  std::uint64_t largestLeaf = 0;     ///< most references in one leaf
  std::uint32_t depth = 0;           ///< levels; a tree that is one leaf has 1
  double sahCost = 0.0;              ///< expected cost of a ray that meets the bounds
  std::uint64_t bytes = 0;           ///< nodes and references; the objects are not counted
};

/// Counts a tree: `nodes` depth first, `bounds` of the root's cell. Linear in the nodes.
[[nodiscard]] TreeStatistics treeStatistics(std::span<const Node> nodes, const Box3& bounds,
                                            const CostModel& cost);

}  // namespace planetree
