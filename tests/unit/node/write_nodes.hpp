#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/node/node.hpp>

#include "node/node_array.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace planetree::test {

inline void expectLeaf(const Node& node, std::uint32_t firstReference, std::uint32_t count) {
  ASSERT_TRUE(node.isLeaf());
  EXPECT_EQ(node.leaf().firstReference(), firstReference);
  EXPECT_EQ(node.leaf().count(), count);
}

inline void expectSplit(const Node& node, Axis axis, float position, std::uint32_t rightOffset) {
  ASSERT_FALSE(node.isLeaf());
  EXPECT_EQ(node.split().axis(), axis);
  EXPECT_EQ(node.split().position(), position);
  EXPECT_EQ(node.split().rightOffset(), rightOffset);
}

inline constexpr Box3 kUnitCube = {.lower = {0, 0, 0}, .upper = {1, 1, 1}};

/// Adds a leaf with these objects.
inline void addLeaf(detail::NodeArray& array, const std::vector<std::uint32_t>& objects) {
  const std::span<std::uint32_t> room = array.addLeaf(objects.size());
  ASSERT_EQ(room.size(), objects.size());
  std::copy(objects.begin(), objects.end(), room.begin());
}

}  // namespace planetree::test
