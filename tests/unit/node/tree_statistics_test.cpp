#include <planetree/node/tree_statistics.hpp>

#include <planetree/build_tree.hpp>

#include "unit/split/random_meshes.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace planetree {
namespace {

constexpr NodeCosts kCost = {.traversalCost = 2.0, .intersectionCost = 3.0};
// Its area is 2 (8 + 8 + 4) = 40.
constexpr Box3 kBounds = {.lower = {0, 0, 0}, .upper = {4, 2, 2}};

TEST(TreeStatistics, AreAllZeroWithoutNodes) {
  const TreeStatistics statistics = treeStatistics({}, kBounds, kCost);
  EXPECT_EQ(statistics.leafNodeCount, 0u);
  EXPECT_EQ(statistics.depth, 0u);
  EXPECT_EQ(statistics.bytes, 0u);
  EXPECT_EQ(statistics.sahCost, 0.0);
  EXPECT_TRUE(statistics.levels.empty());
  EXPECT_TRUE(statistics.leafSizes.empty());
}

TEST(TreeStatistics, OfASingleLeaf) {
  const std::vector<Node> nodes = {LeafNode(0, 5)};
  const TreeStatistics statistics = treeStatistics(nodes, kBounds, kCost);
  EXPECT_EQ(statistics.splitNodeCount, 0u);
  EXPECT_EQ(statistics.leafNodeCount, 1u);
  EXPECT_EQ(statistics.emptyLeafCount, 0u);
  EXPECT_EQ(statistics.referenceCount, 5u);
  EXPECT_EQ(statistics.largestLeaf, 5u);
  EXPECT_EQ(statistics.depth, 1u);
  EXPECT_EQ(statistics.sahCost, 15.0);
  EXPECT_EQ(statistics.bytes, 8u + 5u * 4u);
}

TEST(TreeStatistics, OfAnEmptyLeaf) {
  const std::vector<Node> nodes = {LeafNode(0, 0)};
  const TreeStatistics statistics = treeStatistics(nodes, Box3{}, kCost);
  EXPECT_EQ(statistics.leafNodeCount, 1u);
  EXPECT_EQ(statistics.emptyLeafCount, 1u);
  EXPECT_EQ(statistics.largestLeaf, 0u);
  EXPECT_EQ(statistics.depth, 1u);
  EXPECT_EQ(statistics.sahCost, 0.0);
  EXPECT_EQ(statistics.bytes, 8u);
}

TEST(TreeStatistics, OfATreeOfThreeLevels) {
  const std::vector<Node> nodes = {
      SplitNode(Axis::X, 1.0f, 2),  // cell of area 40
      LeafNode(0, 1),               // 1 x 2 x 2: area 16
      SplitNode(Axis::Y, 0.5f, 2),  // 3 x 2 x 2: area 32
      LeafNode(1, 0),               // 3 x 0.5 x 2: area 2 (1.5 + 6 + 1) = 17
      LeafNode(1, 7),               // 3 x 1.5 x 2: area 2 (4.5 + 6 + 3) = 27
  };
  const TreeStatistics statistics = treeStatistics(nodes, kBounds, kCost);
  EXPECT_EQ(statistics.splitNodeCount, 2u);
  EXPECT_EQ(statistics.leafNodeCount, 3u);
  EXPECT_EQ(statistics.emptyLeafCount, 1u);
  EXPECT_EQ(statistics.referenceCount, 8u);
  EXPECT_EQ(statistics.largestLeaf, 7u);
  EXPECT_EQ(statistics.depth, 3u);
  // 2 (1 + 32/40) + 3 (1 16/40 + 7 27/40); the empty cell has no bonus in what a tree costs.
  EXPECT_DOUBLE_EQ(statistics.sahCost, 2.0 * 1.8 + 3.0 * (0.4 + 7.0 * 0.675));
  EXPECT_EQ(statistics.bytes, 5u * 8u + 8u * 4u);
}

TEST(TreeStatistics, TellTheLevelsOfATreeApart) {
  const std::vector<Node> nodes = {
      SplitNode(Axis::X, 1.0f, 2),  // cell of area 40
      LeafNode(0, 1),               // area 16
      SplitNode(Axis::Y, 0.5f, 2),  // area 32
      LeafNode(1, 0),               // area 17
      LeafNode(1, 7),               // area 27
  };
  const std::vector<LevelStatistics> levels = treeStatistics(nodes, kBounds, kCost).levels;
  ASSERT_EQ(levels.size(), 3u);
  EXPECT_EQ(levels[0].splitNodeCount, 1u);
  EXPECT_EQ(levels[0].leafNodeCount, 0u);
  EXPECT_DOUBLE_EQ(levels[0].traversalCost, 2.0);
  EXPECT_EQ(levels[0].intersectionCost, 0.0);

  EXPECT_EQ(levels[1].splitNodeCount, 1u);
  EXPECT_EQ(levels[1].leafNodeCount, 1u);
  EXPECT_EQ(levels[1].emptyLeafCount, 0u);
  EXPECT_EQ(levels[1].referenceCount, 1u);
  EXPECT_DOUBLE_EQ(levels[1].traversalCost, 2.0 * 32.0 / 40.0);
  EXPECT_DOUBLE_EQ(levels[1].intersectionCost, 3.0 * 16.0 / 40.0);

  EXPECT_EQ(levels[2].splitNodeCount, 0u);
  EXPECT_EQ(levels[2].leafNodeCount, 2u);
  EXPECT_EQ(levels[2].emptyLeafCount, 1u);
  EXPECT_EQ(levels[2].referenceCount, 7u);
  EXPECT_DOUBLE_EQ(levels[2].intersectionCost, 3.0 * 7.0 * 27.0 / 40.0);
}

TEST(TreeStatistics, CountLeavesBySizeAndNameOnlyTheSizesThatOccur) {
  const std::vector<Node> nodes = {SplitNode(Axis::X, 1.0f, 2),
                                   LeafNode(0, 0),
                                   SplitNode(Axis::X, 2.0f, 2),
                                   LeafNode(0, 100'000),
                                   SplitNode(Axis::X, 3.0f, 2),
                                   LeafNode(0, 3),
                                   SplitNode(Axis::X, 3.5f, 2),
                                   LeafNode(0, 100'000),
                                   LeafNode(0, 0)};
  const std::vector<LeafSizeCount> sizes = treeStatistics(nodes, kBounds, kCost).leafSizes;
  ASSERT_EQ(sizes.size(), 3u);
  EXPECT_EQ(sizes[0].objectCount, 0u);
  EXPECT_EQ(sizes[0].leafCount, 2u);
  EXPECT_EQ(sizes[1].objectCount, 3u);
  EXPECT_EQ(sizes[1].leafCount, 1u);
  EXPECT_EQ(sizes[2].objectCount, 100'000u);
  EXPECT_EQ(sizes[2].leafCount, 2u);
}

TEST(TreeStatistics, CountsEveryCellAsMetInBoundsWithoutArea) {
  const std::vector<Node> nodes = {SplitNode(Axis::X, 1.0f, 2), LeafNode(0, 2), LeafNode(2, 3)};
  const Box3 line = {.lower = {0, 0, 0}, .upper = {4, 0, 0}};
  EXPECT_EQ(treeStatistics(nodes, line, kCost).sahCost, 2.0 + 3.0 * 5.0);
}

TEST(TreeStatistics, CountsLeavesTooLargeForThirtyTwoBitsTogether) {
  const std::vector<Node> nodes = {SplitNode(Axis::X, 1.0f, 2), LeafNode(0, 0xFFFF'FFFFu),
                                   LeafNode(0, 0xFFFF'FFFFu)};
  const TreeStatistics statistics = treeStatistics(nodes, kBounds, kCost);
  EXPECT_EQ(statistics.referenceCount, 0x1'FFFF'FFFEu);
  EXPECT_EQ(statistics.largestLeaf, 0xFFFF'FFFFu);
}

TEST(TreeStatistics, SurviveTheDeepestTree) {
  // A spine to the right: each split's left child is a leaf.
  std::vector<Node> nodes;
  for (std::uint32_t level = 1; level < kMaxTreeDepth; ++level) {
    nodes.push_back(SplitNode(Axis::X, 4.0f - 4.0f / static_cast<float>(level + 1), 2));
    nodes.push_back(LeafNode(0, 0));
  }
  nodes.push_back(LeafNode(0, 0));
  EXPECT_EQ(treeStatistics(nodes, kBounds, kCost).depth, kMaxTreeDepth);
}

TEST(TreeStatistics, OfABuiltTreeAreThoseOfItsArrays) {
  test::MeshGenerator generator(46'368);
  const auto tree = buildTree(generator.soupOfAnyCoordinates<float>(1000, 0.1f));
  const TreeStatistics statistics = tree.statistics();
  EXPECT_EQ(statistics.splitNodeCount + statistics.leafNodeCount, tree.nodes().size());
  EXPECT_EQ(statistics.leafNodeCount, statistics.splitNodeCount + 1);
  EXPECT_EQ(statistics.referenceCount, tree.view().references.size());
  EXPECT_EQ(statistics.bytes, tree.nodes().size_bytes() + tree.view().references.size_bytes());
}

}  // namespace
}  // namespace planetree
