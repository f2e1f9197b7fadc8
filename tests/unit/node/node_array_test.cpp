#include "../../../src/node/node_array.hpp"

#include <planetree/node/validate_tree.hpp>

#include "unit/node/write_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace planetree::detail {
namespace {

using test::addLeaf;
using test::expectLeaf;
using test::expectSplit;
using test::kUnitCube;

void expectReferences(const NodeArray& array, const std::vector<std::uint32_t>& wanted) {
  const auto references = array.references();
  EXPECT_EQ(std::vector(references.begin(), references.end()), wanted);
}

TEST(NodeArray, IsEmptyAtFirst) {
  NodeArray array;
  EXPECT_TRUE(array.nodes().empty());
  EXPECT_TRUE(array.references().empty());
}

TEST(NodeArray, HoldsOneLeaf) {
  NodeArray array;
  addLeaf(array, {4, 7});
  const auto nodes = array.nodes();
  ASSERT_EQ(nodes.size(), 1u);
  expectLeaf(nodes[0], 0, 2);
  expectReferences(array, {4, 7});
}

TEST(NodeArray, KeepsDepthFirstOrder) {
  NodeArray array;
  const std::size_t root = array.addSplit(Axis::X, 0.5f);
  const std::size_t left = array.addSplit(Axis::Y, 0.25f);
  EXPECT_EQ(root, 0u);
  EXPECT_EQ(left, 1u);
  addLeaf(array, {0, 1});
  array.beginRightChild(left);
  addLeaf(array, {});
  array.beginRightChild(root);
  addLeaf(array, {1, 2, 3});

  const auto nodes = array.nodes();
  ASSERT_EQ(nodes.size(), 5u);
  expectSplit(nodes[0], Axis::X, 0.5f, 4);
  expectSplit(nodes[1], Axis::Y, 0.25f, 2);
  expectLeaf(nodes[2], 0, 2);
  expectLeaf(nodes[3], 2, 0);
  expectLeaf(nodes[4], 2, 3);
  const auto references = array.references();
  expectReferences(array, {0, 1, 1, 2, 3});
  EXPECT_FALSE(validateTree(nodes, references, kUnitCube, 4));
}

TEST(NodeArray, KeepsTheBoxOfEachReference) {
  const auto boxAt = [](float x) { return Box3{{x, 0, 0}, {x + 1, 1, 1}}; };
  NodeArray array;
  addLeaf(array, {9});
  array.boxesOfLastLeaf()[0] = boxAt(9);
  addLeaf(array, {4, 7});
  ASSERT_EQ(array.boxesOfLastLeaf().size(), 2u);
  array.boxesOfLastLeaf()[0] = boxAt(4);
  array.boxesOfLastLeaf()[1] = boxAt(7);
  const auto boxes = array.boxes();
  EXPECT_EQ(std::vector(boxes.begin(), boxes.end()), (std::vector{boxAt(9), boxAt(4), boxAt(7)}));
}

}  // namespace
}  // namespace planetree::detail
