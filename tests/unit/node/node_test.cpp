#include <planetree/node/node.hpp>

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace planetree {
namespace {

constexpr std::uint32_t kSeed = 223'606;

std::vector<float> extremePositions() {
  using Limits = std::numeric_limits<float>;
  return {0.0f,
          -0.0f,
          1.0f,
          -1.5f,
          Limits::max(),
          Limits::lowest(),
          Limits::min(),
          Limits::denorm_min(),
          -Limits::denorm_min()};
}

void expectSplit(Axis axis, float position, std::uint32_t rightOffset) {
  const Node node = SplitNode(axis, position, rightOffset);
  ASSERT_FALSE(node.isLeaf());
  EXPECT_EQ(node.split().axis(), axis);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(node.split().position()),
            std::bit_cast<std::uint32_t>(position));
  EXPECT_EQ(node.split().rightOffset(), rightOffset);
}

void expectLeaf(std::uint32_t firstReference, std::uint32_t count) {
  const Node node = LeafNode(firstReference, count);
  ASSERT_TRUE(node.isLeaf());
  EXPECT_EQ(node.leaf().firstReference(), firstReference);
  EXPECT_EQ(node.leaf().count(), count);
}

TEST(SplitNode, GivesBackExtremeValues) {
  for (const Axis axis : kAxes) {
    for (const float position : extremePositions()) {
      for (const std::uint32_t offset : {0u, 2u, 3u, 0x1555'5555u, kMaxNodeCount})
        expectSplit(axis, position, offset);
    }
  }
}

TEST(LeafNode, GivesBackExtremeValues) {
  for (const std::uint32_t first : {0u, 1u, 0x2AAA'AAAAu, kMaxReferenceCount}) {
    for (const std::uint32_t count : {0u, 1u, 0x8000'0000u, 0xFFFF'FFFFu})
      expectLeaf(first, count);
  }
}

TEST(Node, GivesBackRandomValues) {
  std::mt19937 random(kSeed);
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::uniform_int_distribution<std::uint32_t> offsets(0, kMaxNodeCount);
  std::uniform_int_distribution<std::uint32_t> words;
  for (int i = 0; i < 10'000; ++i) {
    expectLeaf(offsets(random), words(random));
    const auto position = std::bit_cast<float>(words(random));
    expectSplit(kAxes[words(random) % 3], position, offsets(random));
  }
}

TEST(Node, TellsLeavesFromSplitsByTheLowestTwoBits) {
  std::mt19937 random(kSeed + 1);
  std::uniform_int_distribution<std::uint32_t> words;
  for (int i = 0; i < 10'000; ++i) {
    const std::array<std::uint32_t, 2> bytes = {words(random), words(random)};
    Node node = LeafNode(0, 0);
    std::memcpy(static_cast<void*>(&node), bytes.data(), sizeof(node));
    EXPECT_EQ(node.isLeaf(), (bytes[0] & 3u) == 3u);
  }
}

TEST(Node, IsOneWordInTheOrderLinkThenPositionOrCount) {
  // Saved trees rely on these bytes.
  const Node split = SplitNode(Axis::Z, 1.0f, 5);
  const Node leaf = LeafNode(6, 7);
  const auto words = [](const Node& node) {
    return std::bit_cast<std::array<std::uint32_t, 2>>(node);
  };
  EXPECT_EQ(words(split), (std::array<std::uint32_t, 2>{5u << 2 | 2u, 0x3F80'0000u}));
  EXPECT_EQ(words(leaf), (std::array<std::uint32_t, 2>{6u << 2 | 3u, 7u}));
}

TEST(SplitNode, FindsItsChildrenInTheArray) {
  const std::array<Node, 5> tree = {
      SplitNode(Axis::X, 0.5f, 4),   // children 1 and 4
      SplitNode(Axis::Y, 0.25f, 2),  // children 2 and 3
      LeafNode(0, 1),
      LeafNode(1, 1),
      LeafNode(2, 1),
  };
  EXPECT_EQ(&tree[0].split().left(), &tree[1]);
  EXPECT_EQ(&tree[0].split().right(), &tree[4]);
  EXPECT_EQ(&tree[1].split().left(), &tree[2]);
  EXPECT_EQ(&tree[1].split().right(), &tree[3]);
}

TEST(SplitNode, FindsItsChildrenInACopyOfTheWholeArray) {
  const std::vector<Node> tree = {SplitNode(Axis::X, 0.5f, 2), LeafNode(0, 0), LeafNode(0, 0)};
  const std::vector<Node> copy = tree;
  EXPECT_EQ(&copy[0].split().left(), &copy[1]);
  EXPECT_EQ(&copy[0].split().right(), &copy[2]);
}

}  // namespace
}  // namespace planetree
