#include <planetree/mesh/clip_triangle.hpp>

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace planetree::test {
namespace {

template <class T>
class ClipTriangle : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ClipTriangle, Scalars);

TYPED_TEST(ClipTriangle, KeepsATriangleInsideTheCellAsItIs) {
  using T = TypeParam;
  const Box3 clipped =
      clippedTriangleBounds<T>({0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}, {{-1, -1, -1}, {2, 2, 2}});
  EXPECT_EQ(clipped, (Box3{{0, 0, 0}, {1, 1, 0.5f}}));
}

TYPED_TEST(ClipTriangle, BoundsThePartInsideTightly) {
  using T = TypeParam;
  // The hypotenuse crosses x = 1 at y = 3.
  const Box3 clipped =
      clippedTriangleBounds<T>({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {{1, -1, -1}, {5, 5, 1}});
  EXPECT_EQ(clipped.lower.x, 1.0f);
  EXPECT_EQ(clipped.upper.x, 4.0f);
  EXPECT_GE(clipped.upper.y, 3.0f);
  EXPECT_LE(clipped.upper.y, 3.000001f);
  EXPECT_EQ(clipped.lower.z, 0.0f);
  EXPECT_EQ(clipped.upper.z, 0.0f);
}

TYPED_TEST(ClipTriangle, IsEmptyWhereOnlyTheBoxesMeet) {
  using T = TypeParam;
  EXPECT_TRUE(
      clippedTriangleBounds<T>({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {{3, 3, -1}, {4, 4, 1}}).isEmpty());
  EXPECT_TRUE(
      clippedTriangleBounds<T>({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {{5, 5, -1}, {6, 6, 1}}).isEmpty());
}

TYPED_TEST(ClipTriangle, KeepsATriangleThatOnlyTouchesTheCell) {
  using T = TypeParam;
  EXPECT_FALSE(
      clippedTriangleBounds<T>({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {{2, 2, -1}, {4, 4, 1}}).isEmpty());
  EXPECT_FALSE(
      clippedTriangleBounds<T>({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {{4, 0, 0}, {5, 1, 1}}).isEmpty());
}

TEST(ClipTriangleOfDoubles, LeavesRoomForRounding) {
  // The edge from the origin to (x, y) meets x = 2 at q + 1 / x, just above the float q, but so
  // little that the nearest double is q itself.
  constexpr std::int64_t kQ = (1 << 23) + 1;
  constexpr std::int64_t kX = (1 << 30) + 1;
  const auto q = static_cast<double>(kQ);
  const auto x = static_cast<double>(kX);
  const auto y = static_cast<double>((kQ * kX + 1) / 2);
  ASSERT_EQ(2.0 * y / x, q);
  for (const double sign : {1.0, -1.0}) {
    const Box3 clipped = clippedTriangleBounds<double>({0, 0, 0}, {x, sign * y, 0}, {0, 0, 1},
                                                       {{-1, -0x1p30f, -1}, {2, 0x1p30f, 1}});
    EXPECT_GT(clipped.upper.y - clipped.lower.y, static_cast<float>(q)) << sign;
  }
}

TYPED_TEST(ClipTriangle, KeepsAFlatTriangleFlat) {
  using T = TypeParam;
  Random random(71);
  for (int i = 0; i < 1000; ++i) {
    const auto z = static_cast<float>(random.between(-1, 1));
    const auto corner = [&] {
      auto p = random.pointIn<T>({-2, -2, 0}, {2, 2, 0});
      p.z = z;
      return p;
    };
    const Box3 clipped =
        clippedTriangleBounds(corner(), corner(), corner(), {{-1, -1, -1}, {1, 1, 1}});
    if (clipped.isEmpty())
      continue;
    ASSERT_EQ(clipped.lower.z, z);
    ASSERT_EQ(clipped.upper.z, z);
  }
}

/// Points of the triangle that lie in the cell by a margin that no rounding of the test reaches
/// must lie in the clipped box.
TYPED_TEST(ClipTriangle, NeverCutsOffAPointInsideTheCell) {
  using T = TypeParam;
  Random random(72);
  int pointsInside = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double scale = std::exp2(std::floor(random.between(-30, 30)));
    const double flatness = random.chance(0.5) ? 1.0 : std::exp2(random.between(-40, 0));
    const auto point = [&](double reach) {
      const auto p = random.pointIn<double>({-reach, -reach, -reach}, {reach, reach, reach});
      return Vec3d{p.x * scale, p.y * scale, p.z * scale * flatness};
    };
    const auto a = static_cast<Vec3<T>>(point(2));
    const auto b = static_cast<Vec3<T>>(point(2));
    const auto c = static_cast<Vec3<T>>(point(2));
    Box3 cell;
    cell.extend(static_cast<Vec3f>(point(1)));
    cell.extend(static_cast<Vec3f>(point(1)));
    const Box3 clipped = clippedTriangleBounds(a, b, c, cell);
    if (!clipped.isEmpty()) {
      ASSERT_TRUE(contains(cell, clipped));
    }
    for (int j = 0; j < 50; ++j) {
      const long double u = random.unit();
      const long double v = random.unit() * (1.0L - u);
      bool isInCell = true;
      bool isInClipped = true;
      for (const Axis axis : kAxes) {
        const auto at = [axis](const auto& p) { return static_cast<long double>(p[axis]); };
        const long double x = at(a) + u * (at(b) - at(a)) + v * (at(c) - at(a));
        isInCell = isInCell && x >= at(cell.lower) && x <= at(cell.upper);
        // The point itself is rounded, by far less than a float can show.
        const long double tolerance = 1e-17L * 4 * scale;
        isInClipped =
            isInClipped && x >= at(clipped.lower) - tolerance && x <= at(clipped.upper) + tolerance;
      }
      if (!isInCell)
        continue;
      ++pointsInside;
      ASSERT_TRUE(isInClipped) << describeSeed();
    }
  }
  EXPECT_GT(pointsInside, 10'000);
}

}  // namespace
}  // namespace planetree::test
