#pragma once

#include <planetree/node/node.hpp>

#include <gtest/gtest.h>

#include <cstdint>

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

}  // namespace planetree::test
