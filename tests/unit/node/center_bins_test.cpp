#include "../../../src/node/center_bins.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace planetree::detail {
namespace {

Box3 cubeAt(const Vec3f& center, float size) {
  const Vec3f half = {size / 2, size / 2, size / 2};
  return {center - half, center + half};
}

Box3 centersOf(const std::vector<Box3>& boxes) {
  Box3 centers;
  for (const Box3& box : boxes) {
    centers.extend(
        Vec3f{centerAlong(box, Axis::X), centerAlong(box, Axis::Y), centerAlong(box, Axis::Z)});
  }
  return centers;
}

std::vector<std::uint32_t> placesOf(const std::vector<Box3>& boxes) {
  std::vector<std::uint32_t> places(boxes.size());
  std::iota(places.begin(), places.end(), 0u);
  return places;
}

TEST(CenterBins, CutBetweenTwoClusters) {
  std::vector<Box3> boxes;
  for (int i = 0; i < 30; ++i)
    boxes.push_back(cubeAt({0.01f * static_cast<float>(i), i % 3 == 0 ? 8.0f : 0.0f, 0}, 0.1f));
  auto places = placesOf(boxes);
  const auto cut = CenterBins().divide(boxes, centersOf(boxes), places, 1.0);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->axis, Axis::Y);
  ASSERT_EQ(cut->leftCount, 20u);
  for (std::size_t i = 0; i < places.size(); ++i)
    EXPECT_EQ(places[i] % 3 == 0, i >= cut->leftCount);
}

TEST(CenterBins, KeepTheOrderOnBothSides) {
  test::Random random(3);
  std::vector<Box3> boxes;
  for (int i = 0; i < 500; ++i)
    boxes.push_back(cubeAt(random.pointIn<float>({-1, -1, -1}, {1, 1, 1}), 0.05f));
  auto places = placesOf(boxes);
  const auto cut = CenterBins().divide(boxes, centersOf(boxes), places, 12.0);
  ASSERT_TRUE(cut);
  ASSERT_GT(cut->leftCount, 0u);
  ASSERT_LT(cut->leftCount, places.size());
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(cut->leftCount);
  EXPECT_TRUE(std::is_sorted(places.begin(), middle));
  EXPECT_TRUE(std::is_sorted(middle, places.end()));
  std::sort(places.begin(), places.end());
  EXPECT_EQ(places, placesOf(boxes));
}

TEST(CenterBins, FindNothingWhereAllCentersAreOne) {
  const std::vector<Box3> boxes(20, cubeAt({1, 2, 3}, 0.5f));
  auto places = placesOf(boxes);
  EXPECT_FALSE(CenterBins().divide(boxes, centersOf(boxes), places, 12.0));
  EXPECT_EQ(places, placesOf(boxes));
}

TEST(CenterBins, DivideAtTheSmallestAndTheLargestScales) {
  for (const float scale : {0x1p-140f, 0x1p-120f, 0x1p100f, 0x1p126f}) {
    SCOPED_TRACE(scale);
    std::vector<Box3> boxes;
    for (int i = 0; i < 40; ++i)
      boxes.push_back(cubeAt({i < 20 ? -scale : scale, 0, 0}, scale * 0.25f));
    auto places = placesOf(boxes);
    const auto cut = CenterBins().divide(boxes, centersOf(boxes), places, 1.0);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->leftCount, 20u);
  }
}

TEST(CenterBins, CanBeUsedAgain) {
  CenterBins used;
  for (const float offset : {0.0f, 100.0f, -3.0f}) {
    std::vector<Box3> boxes;
    for (int i = 0; i < 64; ++i)
      boxes.push_back(cubeAt({offset + static_cast<float>(i * i), 0, 0}, 1.0f));
    auto places = placesOf(boxes);
    auto again = places;
    const auto first = CenterBins().divide(boxes, centersOf(boxes), places, 4.0);
    const auto second = used.divide(boxes, centersOf(boxes), again, 4.0);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->leftCount, second->leftCount);
    EXPECT_EQ(places, again);
  }
}

}  // namespace
}  // namespace planetree::detail
