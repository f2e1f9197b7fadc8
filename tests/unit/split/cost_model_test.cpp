#include <planetree/split/cost_model.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace planetree {
namespace {

constexpr CostModel kTextbook = {.traversalCost = 0.0, .intersectionCost = 1.0, .emptyBonus = 0.0};

TEST(CostModel, IsTheTextbooksSamWithoutTraversalCostAndBonus) {
  // (3 * 20 + 5 * 12) / 32
  EXPECT_EQ(kTextbook.splitCost(3, 20.0, 5, 12.0, 32.0), 3.75);
}

TEST(CostModel, AddsTheTraversalCostOnceAndScalesObjects) {
  constexpr CostModel cost = {.traversalCost = 2.0, .intersectionCost = 4.0, .emptyBonus = 0.5};
  EXPECT_EQ(cost.splitCost(3, 20.0, 5, 12.0, 32.0), 2.0 + 4.0 * 3.75);
}

TEST(CostModel, ForgivesAPartOfTheWholeCostWhereASideIsEmpty) {
  constexpr CostModel cost = {.traversalCost = 2.0, .intersectionCost = 4.0, .emptyBonus = 0.25};
  EXPECT_EQ(cost.splitCost(0, 20.0, 5, 16.0, 32.0), (2.0 + 4.0 * 2.5) * 0.75);
  EXPECT_EQ(cost.splitCost(5, 16.0, 0, 20.0, 32.0), (2.0 + 4.0 * 2.5) * 0.75);
}

TEST(CostModel, CountsBothSidesAsMetInACellWithoutArea) {
  EXPECT_EQ(kTextbook.splitCost(3, 0.0, 5, 0.0, 0.0), 8.0);
}

TEST(CostModel, StaysFiniteForTheLargestCellsAndCounts) {
  constexpr double kLargestArea = 6.0 * 4.0 * 0x1p128 * 0x1p128;
  constexpr std::uint64_t kMany = std::numeric_limits<std::uint32_t>::max();
  EXPECT_TRUE(
      std::isfinite(CostModel{}.splitCost(kMany, kLargestArea, kMany, kLargestArea, kLargestArea)));
}

TEST(CostModel, PaysForEachObjectOfALeaf) {
  constexpr CostModel cost = {.traversalCost = 2.0, .intersectionCost = 0.5, .emptyBonus = 0.0};
  EXPECT_EQ(cost.leafCost(0), 0.0);
  EXPECT_EQ(cost.leafCost(7), 3.5);
  EXPECT_EQ(CostModel{}.leafCost(std::numeric_limits<std::uint32_t>::max()), 4294967295.0);
}

}  // namespace
}  // namespace planetree
