#include "node/visit_weight.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace planetree::detail {
namespace {

TEST(VisitWeight, IsTheSurfaceAreaWhereAllRaysComeFromOutside) {
  const Box3 box{{1, 2, 3}, {2, 4, 6}};
  EXPECT_EQ(VisitWeight()(box), box.surfaceArea());
  EXPECT_EQ(VisitWeight()(Box3()), 0.0);
}

TEST(VisitWeight, CountsNothingForEmptyOrFlatBoxesOrTrees) {
  const VisitWeight weight({{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(weight(Box3()), 0.0);
  const Box3 wall{{0, 0, 0}, {1, 0, 1}};
  EXPECT_EQ(weight(wall), wall.surfaceArea());
  EXPECT_EQ(VisitWeight(wall)(wall), wall.surfaceArea());
  EXPECT_EQ(VisitWeight(Box3())(wall), wall.surfaceArea());
}

/// Rays from all points of a unit cube in all directions, each a quarter of the mean chord long:
/// how many meet a box is to its weight as for any other box.
TEST(VisitWeight, IsInProportionToTheRaysThatMeetABox) {
  const Box3 tree{{0, 0, 0}, {1, 1, 1}};
  const VisitWeight weight(tree);
  constexpr double kLength = 1.0 / 6.0;
  constexpr int kRays = 400'000;
  test::Random random(5);
  const Box3 boxes[] = {{{0.3f, 0.3f, 0.3f}, {0.7f, 0.7f, 0.7f}},
                        {{0.3f, 0.4f, 0.2f}, {0.7f, 0.4f, 0.8f}},
                        {{0.4f, 0.4f, 0.2f}, {0.45f, 0.45f, 0.8f}}};
  double hits[3] = {};
  for (int i = 0; i < kRays; ++i) {
    const Vec3d origin = random.pointIn<double>({0, 0, 0}, {1, 1, 1});
    const Vec3d direction = random.direction();
    for (int k = 0; k < 3; ++k) {
      double from = 0.0;
      double to = kLength;
      for (const Axis axis : kAxes) {
        const double a =
            (static_cast<double>(boxes[k].lower[axis]) - origin[axis]) / direction[axis];
        const double b =
            (static_cast<double>(boxes[k].upper[axis]) - origin[axis]) / direction[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
      }
      hits[k] += from <= to ? 1.0 : 0.0;
    }
  }
  for (int k = 1; k < 3; ++k)
    EXPECT_NEAR(hits[k] / hits[0], weight(boxes[k]) / weight(boxes[0]), 0.02);
}

}  // namespace
}  // namespace planetree::detail
