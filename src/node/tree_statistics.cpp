#include <planetree/node/tree_statistics.hpp>
#include <planetree/split/split_plane.hpp>

#include <algorithm>
#include <vector>

namespace planetree {

TreeStatistics treeStatistics(std::span<const Node> nodes, const Box3& bounds,
                              const CostModel& cost) {
  struct Cell {
    const Node* node;
    Box3 box;
    std::uint32_t level;
  };
  TreeStatistics statistics;
  if (nodes.empty())
    return statistics;

  const double rootArea = bounds.surfaceArea();
  std::vector<Cell> cells = {{&nodes.front(), bounds, 1}};
  while (!cells.empty()) {
    const Cell cell = cells.back();
    cells.pop_back();
    statistics.depth = std::max(statistics.depth, cell.level);
    const double chance = rootArea > 0.0 ? cell.box.surfaceArea() / rootArea : 1.0;
    if (cell.node->isLeaf()) {
      const std::uint64_t count = cell.node->leaf().count();
      ++statistics.leafNodeCount;
      if (count == 0)
        ++statistics.emptyLeafCount;
      statistics.referenceCount += count;
      statistics.largestLeaf = std::max(statistics.largestLeaf, count);
      statistics.sahCost += chance * cost.leafCost(count);
    } else {
      const SplitNode& split = cell.node->split();
      const SplitPlane plane{.axis = split.axis(), .position = split.position()};
      ++statistics.splitNodeCount;
      statistics.sahCost += chance * cost.traversalCost;
      cells.push_back({&split.right(), calculateRightBBox(plane, cell.box), cell.level + 1});
      cells.push_back({&split.left(), calculateLeftBBox(plane, cell.box), cell.level + 1});
    }
  }
  statistics.bytes = nodes.size_bytes() + statistics.referenceCount * sizeof(std::uint32_t);
  return statistics;
}

}  // namespace planetree
