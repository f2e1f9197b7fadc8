#include <planetree/geometry/box3.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace planetree {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(Box3, IsEmptyWhenDefaultMade) {
  const Box3 empty;
  EXPECT_TRUE(empty.isEmpty());
  EXPECT_EQ(empty.surfaceArea(), 0.0);
  EXPECT_EQ(empty.lower.x, kInfinity);
  EXPECT_EQ(empty.upper.x, -kInfinity);
}

TEST(Box3, IsEmptyWhenTurnedInsideOutOrNan) {
  EXPECT_TRUE((Box3{{0, 0, 1}, {1, 1, 0}}.isEmpty()));
  EXPECT_TRUE((Box3{{kNan, 0, 0}, {1, 1, 1}}.isEmpty()));
  EXPECT_TRUE((Box3{{0, 0, 0}, {1, 1, kNan}}.isEmpty()));
  EXPECT_FALSE((Box3{{1, 1, 1}, {1, 1, 1}}.isEmpty())) << "a single point is not empty";
}

TEST(Box3, GrowsAroundPoints) {
  Box3 box;
  box.extend(Vec3f{1, 2, 3});
  EXPECT_EQ(box, (Box3{{1, 2, 3}, {1, 2, 3}}));
  box.extend(Vec3f{-1, 5, 3});
  EXPECT_EQ(box, (Box3{{-1, 2, 3}, {1, 5, 3}}));
  EXPECT_EQ(box.size(), (Vec3f{2, 3, 0}));
}

TEST(Box3, GrowsAroundBoxes) {
  Box3 box{{0, 0, 0}, {1, 1, 1}};
  box.extend(Box3{{-1, 0.5, 0.5}, {0.5, 0.5, 2}});
  EXPECT_EQ(box, (Box3{{-1, 0, 0}, {1, 1, 2}}));
}

TEST(Box3, DoesNotGrowAroundAnEmptyBox) {
  Box3 box{{0, 0, 0}, {1, 1, 1}};
  box.extend(Box3{});
  EXPECT_EQ(box, (Box3{{0, 0, 0}, {1, 1, 1}}));
}

TEST(Box3, RoundsDoublesOutward) {
  Box3 box;
  box.extend(Vec3d{0.1, 0.1, 1e-60});
  EXPECT_LT(static_cast<double>(box.lower.x), 0.1);
  EXPECT_GT(static_cast<double>(box.upper.x), 0.1);
  EXPECT_EQ(box.lower.z, 0.0f);
  EXPECT_GT(box.upper.z, 0.0f);
  Box3 exact;
  exact.extend(Vec3d{0.5, -2, 3});
  EXPECT_EQ(exact, (Box3{{0.5, -2, 3}, {0.5, -2, 3}}));
}

TEST(Box3, HasTheAreaOfItsSixSides) {
  EXPECT_EQ((Box3{{0, 0, 0}, {1, 2, 3}}.surfaceArea()), 22.0);
  EXPECT_EQ((Box3{{0, 0, 0}, {1, 2, 0}}.surfaceArea()), 4.0) << "both faces of a flat box count";
  EXPECT_EQ((Box3{{0, 0, 0}, {0, 2, 0}}.surfaceArea()), 0.0);
  EXPECT_EQ((Box3{{0, 0, 0}, {1e-30f, 1e-30f, 1e-30f}}.surfaceArea()),
            6.0 * static_cast<double>(1e-30f) * static_cast<double>(1e-30f));
  const float huge = std::numeric_limits<float>::max();
  EXPECT_TRUE(std::isfinite(Box3{{-huge, -huge, -huge}, {huge, huge, huge}}.surfaceArea()));
}

TEST(Intersection, IsTheSharedPart) {
  const Box3 a{{0, 0, 0}, {2, 2, 2}};
  const Box3 b{{1, -1, 1}, {3, 1, 2}};
  EXPECT_EQ(intersection(a, b), (Box3{{1, 0, 1}, {2, 1, 2}}));
  EXPECT_EQ(intersection(b, a), intersection(a, b));
  EXPECT_FALSE(intersection(a, Box3{{2, 0, 0}, {3, 1, 1}}).isEmpty()) << "touching boxes share";
  EXPECT_TRUE(intersection(a, Box3{{2.1f, 0, 0}, {3, 1, 1}}).isEmpty());
  EXPECT_TRUE(intersection(a, Box3{}).isEmpty());
}

TEST(LeftAndRightPart, ShareThePlaneAndNothingElse) {
  const Box3 box{{0, 1, 2}, {10, 11, 12}};
  EXPECT_EQ(leftPart(box, Axis::Y, 4), (Box3{{0, 1, 2}, {10, 4, 12}}));
  EXPECT_EQ(rightPart(box, Axis::Y, 4), (Box3{{0, 4, 2}, {10, 11, 12}}));
  EXPECT_EQ(leftPart(box, Axis::Z, 12), box);
  EXPECT_EQ(rightPart(box, Axis::Z, 12), (Box3{{0, 1, 12}, {10, 11, 12}}));
}

TEST(Contains, LetsSidesTouch) {
  const Box3 outer{{0, 0, 0}, {2, 2, 2}};
  EXPECT_TRUE(contains(outer, outer));
  EXPECT_TRUE(contains(outer, Box3{{0, 1, 1}, {1, 1, 2}}));
  EXPECT_FALSE(contains(outer, Box3{{0, 1, 1}, {1, 1, 2.1f}}));
  EXPECT_TRUE(contains(outer, Box3{}));
  EXPECT_TRUE(contains(Box3{}, Box3{}));
  EXPECT_FALSE(contains(Box3{}, outer));
}

}  // namespace
}  // namespace planetree
