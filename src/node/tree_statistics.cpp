#include <planetree/node/tree_statistics.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

namespace planetree {
namespace {

/// Counts leaves by their size. Nearly all are small, and a few may have any size.
class LeafSizes {
 public:
  void add(std::uint32_t objectCount) {
    ++(objectCount < small_.size() ? small_[objectCount] : large_[objectCount]);
  }

  [[nodiscard]] std::vector<LeafSizeCount> rising() const {
    std::vector<LeafSizeCount> sizes;
    for (std::uint32_t objectCount = 0; objectCount < small_.size(); ++objectCount) {
      if (small_[objectCount] > 0)
        sizes.push_back({objectCount, small_[objectCount]});
    }
    for (const auto& [objectCount, leafCount] : large_)
      sizes.push_back({objectCount, leafCount});
    return sizes;
  }

 private:
  std::array<std::uint64_t, 64> small_ = {};
  std::map<std::uint32_t, std::uint64_t> large_;
};

/// The levels, and what they add to the cost of the tree. Each node counts as often as a random ray
/// that meets the bounds meets its cell.
class LevelCounter {
 public:
  LevelCounter(const Box3& bounds, const NodeCosts& costs)
      : rootArea_(bounds.surfaceArea()), costs_(costs) {}

  void addSplit(std::uint32_t level, const Box3& cell) {
    LevelStatistics& statistics = at(level);
    ++statistics.splitNodeCount;
    statistics.traversalCost += chanceOf(cell) * costs_.traversalCost;
  }

  void addLeaf(std::uint32_t level, const Box3& cell, std::uint32_t objectCount) {
    LevelStatistics& statistics = at(level);
    ++statistics.leafNodeCount;
    statistics.emptyLeafCount += objectCount == 0 ? 1 : 0;
    statistics.referenceCount += objectCount;
    statistics.intersectionCost +=
        chanceOf(cell) * costs_.intersectionCost * static_cast<double>(objectCount);
  }

  [[nodiscard]] std::vector<LevelStatistics> takeLevels() noexcept { return std::move(levels_); }

 private:
  /// `level` counts from 1 at the root.
  [[nodiscard]] LevelStatistics& at(std::uint32_t level) {
    if (level > levels_.size())
      levels_.resize(level);
    return levels_[level - 1];
  }

  [[nodiscard]] double chanceOf(const Box3& cell) const noexcept {
    return rootArea_ > 0.0 ? cell.surfaceArea() / rootArea_ : 1.0;
  }

  double rootArea_;
  NodeCosts costs_;
  std::vector<LevelStatistics> levels_;
};

void addUpLevels(TreeStatistics& statistics) {
  for (const LevelStatistics& level : statistics.levels) {
    statistics.splitNodeCount += level.splitNodeCount;
    statistics.leafNodeCount += level.leafNodeCount;
    statistics.emptyLeafCount += level.emptyLeafCount;
    statistics.referenceCount += level.referenceCount;
    statistics.sahCost += level.traversalCost + level.intersectionCost;
  }
  statistics.depth = static_cast<std::uint32_t>(statistics.levels.size());
}

}  // namespace

TreeStatistics treeStatistics(std::span<const Node> nodes, const Box3& bounds,
                              const NodeCosts& costs) {
  struct Cell {
    const Node* node;
    Box3 box;
    std::uint32_t level;
  };
  TreeStatistics statistics;
  if (nodes.empty())
    return statistics;

  LevelCounter levels(bounds, costs);
  LeafSizes sizes;
  std::vector<Cell> cells = {{&nodes.front(), bounds, 1}};
  while (!cells.empty()) {
    const Cell cell = cells.back();
    cells.pop_back();
    if (cell.node->isLeaf()) {
      const std::uint32_t count = cell.node->leaf().count();
      levels.addLeaf(cell.level, cell.box, count);
      sizes.add(count);
    } else {
      const SplitNode& split = cell.node->split();
      levels.addSplit(cell.level, cell.box);
      cells.push_back(
          {&split.right(), rightPart(cell.box, split.axis(), split.position()), cell.level + 1});
      cells.push_back(
          {&split.left(), leftPart(cell.box, split.axis(), split.position()), cell.level + 1});
    }
  }
  statistics.levels = levels.takeLevels();
  statistics.leafSizes = sizes.rising();
  statistics.largestLeaf = statistics.leafSizes.back().objectCount;
  addUpLevels(statistics);
  statistics.bytes = nodes.size_bytes() + statistics.referenceCount * sizeof(std::uint32_t);
  return statistics;
}

}  // namespace planetree
