#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/node/node.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace planetree {

/// What a ray is taken to pay for a node; only ratios matter.
struct NodeCosts {
  double traversalCost = 0.0;     ///< one split node
  double intersectionCost = 0.0;  ///< one object in a leaf
};

/// One level of a tree in numbers.
struct LevelStatistics {
  std::uint64_t splitNodeCount = 0;
  std::uint64_t leafNodeCount = 0;  ///< the empty ones included
  std::uint64_t emptyLeafCount = 0;
  std::uint64_t referenceCount = 0;  ///< entries of the leaves on this level
  double traversalCost = 0.0;        ///< what the splits add to the cost of the tree
  double intersectionCost = 0.0;     ///< what the leaves add to the cost of the tree
};

/// How many leaves hold this many objects.
struct LeafSizeCount {
  std::uint32_t objectCount = 0;
  std::uint64_t leafCount = 0;
};

/// A tree in numbers.
struct TreeStatistics {
  std::uint64_t splitNodeCount = 0;
  std::uint64_t leafNodeCount = 0;  ///< the empty ones included
  std::uint64_t emptyLeafCount = 0;
  std::uint64_t referenceCount = 0;           ///< entries of all leaves; an object may have several
  std::uint64_t largestLeaf = 0;              ///< most references in one leaf
  std::uint32_t depth = 0;                    ///< levels; a tree that is one leaf has 1
  double sahCost = 0.0;                       ///< expected cost of a ray that meets the bounds
  std::uint64_t bytes = 0;                    ///< nodes and references; the objects are not counted
  std::vector<LevelStatistics> levels = {};   ///< from the root down; `depth` of them
  std::vector<LeafSizeCount> leafSizes = {};  ///< the sizes that occur, rising
};

/// Counts a tree: `nodes` depth first, `bounds` of the root's cell. Linear in the nodes.
[[nodiscard]] TreeStatistics treeStatistics(std::span<const Node> nodes, const Box3& bounds,
                                            const NodeCosts& costs);

}  // namespace planetree
