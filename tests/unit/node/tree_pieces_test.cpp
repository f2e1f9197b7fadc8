#include "../../../src/node/tree_pieces.hpp"

#include <planetree/node/validate_tree.hpp>

#include "unit/node/write_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace planetree::detail {
namespace {

using test::addLeaf;
using test::expectLeaf;
using test::expectSplit;
using test::kUnitCube;

TreePieces leaf(const std::vector<std::uint32_t>& objects) {
  NodeArray array;
  addLeaf(array, objects);
  return TreePieces(std::move(array));
}

/// A subtree of two leaves.
TreePieces splitOfTwo(Axis axis, float position, const std::vector<std::uint32_t>& left,
                      const std::vector<std::uint32_t>& right) {
  NodeArray array;
  const std::size_t split = array.addSplit(axis, position);
  addLeaf(array, left);
  array.beginRightChild(split);
  addLeaf(array, right);
  return TreePieces(std::move(array));
}

TEST(TreePieces, OfOneSubtreeAreThatSubtree) {
  const BinaryTree tree = joinPieces(splitOfTwo(Axis::Z, 0.5f, {3}, {4, 5}));
  ASSERT_EQ(tree.nodes.size(), 3u);
  expectSplit(tree.nodes[0], Axis::Z, 0.5f, 2);
  expectLeaf(tree.nodes[1], 0, 1);
  expectLeaf(tree.nodes[2], 1, 2);
  EXPECT_EQ(tree.references, (std::vector<std::uint32_t>{3, 4, 5}));
}

TEST(TreePieces, JoinDepthFirst) {
  const TreePieces pieces(
      Axis::X, 0.5f,
      TreePieces(Axis::Y, 0.25f, leaf({0, 1, 2}), splitOfTwo(Axis::Z, 0.75f, {1}, {2, 3})),
      TreePieces(Axis::Z, 0.5f, leaf({}), leaf({9})));
  EXPECT_EQ(pieces.referenceCount(), 7u);
  EXPECT_EQ(pieces.subtrees().size(), 4u);

  const BinaryTree tree = joinPieces(pieces);
  ASSERT_EQ(tree.nodes.size(), 9u);
  expectSplit(tree.nodes[0], Axis::X, 0.5f, 6);
  expectSplit(tree.nodes[1], Axis::Y, 0.25f, 2);
  expectLeaf(tree.nodes[2], 0, 3);
  expectSplit(tree.nodes[3], Axis::Z, 0.75f, 2);
  expectLeaf(tree.nodes[4], 3, 1);
  expectLeaf(tree.nodes[5], 4, 2);
  expectSplit(tree.nodes[6], Axis::Z, 0.5f, 2);
  expectLeaf(tree.nodes[7], 6, 0);
  expectLeaf(tree.nodes[8], 6, 1);
  EXPECT_EQ(tree.references, (std::vector<std::uint32_t>{0, 1, 2, 1, 2, 3, 9}));
  EXPECT_FALSE(validateTree(tree.nodes, tree.references, kUnitCube, 10));
}

TEST(TreePieces, KeepSubtreesInTheOrderOfTheirPlaces) {
  const TreePieces pieces(Axis::X, 0.5f, leaf({7}),
                          TreePieces(Axis::Y, 0.5f, leaf({8}), leaf({9})));
  std::vector<std::uint32_t> places;
  for (const TreePieces::Place& place : pieces.top()) {
    if (!place.isSplit())
      places.push_back(place.subtree);
  }
  EXPECT_EQ(places, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(pieces.subtrees()[2].references().front(), 9u);
}

}  // namespace
}  // namespace planetree::detail
