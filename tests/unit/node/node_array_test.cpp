#include "../../../src/node/node_array.hpp"

#include <planetree/node/validate_tree.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace planetree::detail {
namespace {

constexpr Box3 kUnitCube = {.lower = {0, 0, 0}, .upper = {1, 1, 1}};

void addLeaf(NodeArray& array, const std::vector<std::uint32_t>& objects) {
  const std::span<std::uint32_t> room = array.addLeaf(objects.size());
  ASSERT_EQ(room.size(), objects.size());
  std::copy(objects.begin(), objects.end(), room.begin());
}

void expectLeaf(const Node& node, std::uint32_t firstReference, std::uint32_t count) {
  ASSERT_TRUE(node.isLeaf());
  EXPECT_EQ(node.leaf().firstReference(), firstReference);
  EXPECT_EQ(node.leaf().count(), count);
}

void expectSplit(const Node& node, Axis axis, float position, std::uint32_t rightOffset) {
  ASSERT_FALSE(node.isLeaf());
  EXPECT_EQ(node.split().axis(), axis);
  EXPECT_EQ(node.split().position(), position);
  EXPECT_EQ(node.split().rightOffset(), rightOffset);
}

/// A split of two leaves with the objects given.
NodeArray splitOfTwo(Axis axis, float position, const std::vector<std::uint32_t>& left,
                     const std::vector<std::uint32_t>& right) {
  NodeArray array;
  const std::size_t split = array.addSplit(axis, position);
  addLeaf(array, left);
  array.beginRightChild(split);
  addLeaf(array, right);
  return array;
}

TEST(NodeArray, IsEmptyAtFirst) {
  NodeArray array;
  EXPECT_TRUE(array.takeNodes().empty());
  EXPECT_TRUE(array.takeReferences().empty());
}

TEST(NodeArray, HoldsOneLeaf) {
  NodeArray array;
  addLeaf(array, {4, 7});
  const auto nodes = array.takeNodes();
  ASSERT_EQ(nodes.size(), 1u);
  expectLeaf(nodes[0], 0, 2);
  EXPECT_EQ(array.takeReferences(), (std::vector<std::uint32_t>{4, 7}));
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

  const auto nodes = array.takeNodes();
  ASSERT_EQ(nodes.size(), 5u);
  expectSplit(nodes[0], Axis::X, 0.5f, 4);
  expectSplit(nodes[1], Axis::Y, 0.25f, 2);
  expectLeaf(nodes[2], 0, 2);
  expectLeaf(nodes[3], 2, 0);
  expectLeaf(nodes[4], 2, 3);
  const auto references = array.takeReferences();
  EXPECT_EQ(references, (std::vector<std::uint32_t>{0, 1, 1, 2, 3}));
  EXPECT_FALSE(validateTree(nodes, references, kUnitCube, 4));
}

TEST(NodeArray, MovesTheLeavesOfAnAppendedPart) {
  NodeArray array;
  const std::size_t root = array.addSplit(Axis::X, 0.5f);
  addLeaf(array, {0, 1, 2});
  const NodeArray right = splitOfTwo(Axis::Z, 0.75f, {1}, {2, 3});
  array.beginRightChild(root);
  array.append(right);

  const auto nodes = array.takeNodes();
  ASSERT_EQ(nodes.size(), 5u);
  expectSplit(nodes[0], Axis::X, 0.5f, 2);
  expectLeaf(nodes[1], 0, 3);
  expectSplit(nodes[2], Axis::Z, 0.75f, 2);
  expectLeaf(nodes[3], 3, 1);
  expectLeaf(nodes[4], 4, 2);
  const auto references = array.takeReferences();
  EXPECT_EQ(references, (std::vector<std::uint32_t>{0, 1, 2, 1, 2, 3}));
  EXPECT_FALSE(validateTree(nodes, references, kUnitCube, 4));
}

TEST(NodeArray, AppendsPartsOfParts) {
  NodeArray inner;
  const std::size_t innerRoot = inner.addSplit(Axis::Y, 0.5f);
  inner.append(splitOfTwo(Axis::Z, 0.25f, {0}, {1}));
  inner.beginRightChild(innerRoot);
  inner.append(splitOfTwo(Axis::Z, 0.5f, {2}, {3}));

  NodeArray outer;
  const std::size_t root = outer.addSplit(Axis::X, 0.5f);
  addLeaf(outer, {9});
  outer.beginRightChild(root);
  outer.append(inner);

  const auto nodes = outer.takeNodes();
  const auto references = outer.takeReferences();
  EXPECT_EQ(nodes.size(), 9u);
  EXPECT_EQ(references, (std::vector<std::uint32_t>{9, 0, 1, 2, 3}));
  EXPECT_FALSE(validateTree(nodes, references, kUnitCube, 10));
  expectSplit(nodes[2], Axis::Y, 0.5f, 4);
}

TEST(NodeArray, TakesNothingFromAnEmptyPart) {
  NodeArray array;
  addLeaf(array, {5});
  array.append(NodeArray());
  EXPECT_EQ(array.takeNodes().size(), 1u);
  EXPECT_EQ(array.takeReferences().size(), 1u);
}

TEST(NodeArray, LeavesAnAppendedPartAsItWas) {
  NodeArray part = splitOfTwo(Axis::X, 0.5f, {0}, {1});
  NodeArray array;
  addLeaf(array, {7, 8});
  array.append(part);
  const auto nodes = part.takeNodes();
  ASSERT_EQ(nodes.size(), 3u);
  expectLeaf(nodes[2], 1, 1);
}

TEST(NodeArray, KeepsTheBoxOfEachReference) {
  const auto boxAt = [](float x) { return Box3{{x, 0, 0}, {x + 1, 1, 1}}; };
  NodeArray outer;
  addLeaf(outer, {9});
  outer.boxesOfLastLeaf()[0] = boxAt(9);
  NodeArray part;
  addLeaf(part, {4, 7});
  ASSERT_EQ(part.boxesOfLastLeaf().size(), 2u);
  part.boxesOfLastLeaf()[0] = boxAt(4);
  part.boxesOfLastLeaf()[1] = boxAt(7);
  outer.append(part);
  EXPECT_EQ(outer.takeBoxes(), (std::vector<Box3>{boxAt(9), boxAt(4), boxAt(7)}));
}

}  // namespace
}  // namespace planetree::detail
