#include "scene/affine.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace planetree::test {
namespace {

using scene::Affine;

void expectNear(const Vec3d& a, const Vec3d& b, double tolerance = 1e-12) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Affine, RotatesCounterClockwiseAroundItsAxis) {
  const Affine quarter = Affine::rotation({0, 0, 2}, std::numbers::pi / 2);
  expectNear(quarter.vector({1, 0, 0}), {0, 1, 0});
  expectNear(quarter.vector({0, 1, 0}), {-1, 0, 0});
  const double half = std::sqrt(0.5);
  const Affine same = Affine::rotation(std::array{0.0, 0.0, half, half});
  expectNear(same.vector({1, 0, 0}), {0, 1, 0});
}

TEST(Affine, DoesTheRightFactorFirst) {
  const Affine map = Affine::translation({1, 2, 3}) * Affine::scaling({2, 2, 2});
  expectNear(map.point({1, 1, 1}), {3, 4, 5});
  expectNear(map.vector({1, 1, 1}), {2, 2, 2});
}

TEST(Affine, ItsInverseTakesBack) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Affine map = Affine::rotation(random.direction(), random.between(-3, 3)) *
                       Affine::scaling({random.between(0.1, 3), random.between(0.1, 3), -2.0}) *
                       Affine::translation(random.direction());
    const Vec3d point = random.direction();
    ASSERT_TRUE(map.inverse());
    expectNear(map.inverse()->point(map.point(point)), point);
  }
  EXPECT_FALSE(Affine::scaling({1, 0, 1}).inverse());
  EXPECT_FALSE(Affine::scaling({1, 1e-200, 1e-200}).inverse());
}

/// Rows of a matrix, as files have them.
Affine matrix(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}, {}};
}

TEST(Affine, IsSingularAsWellWhereDecimalsAreRounded) {
  EXPECT_FALSE(matrix({1, 2, 3}, {4, 5, 6}, {7, 8, 9}).inverse());
  EXPECT_FALSE(matrix({.1, .2, .3}, {.4, .5, .6}, {.7, .8, .9}).inverse());
  EXPECT_FALSE(matrix({1e-9, 2e-9, 3e-9}, {.4, .5, .6}, {7e5, 8e5, 9e5}).inverse());
  EXPECT_FALSE(matrix({.1, .2, .3}, {.3, .6, .9}, {0, 0, 1}).inverse());
  Random random(7);
  for (int i = 0; i < 10000; ++i) {
    // Without cancellation: each entry of the sum is off by its own last places.
    const double u = random.between(0, 2);
    const double v = random.between(0, 2);
    const Vec3d a{random.between(0, 1), random.between(0, 1), random.between(0, 1)};
    const Vec3d b{random.between(0, 1), random.between(0, 1), random.between(0, 1)};
    EXPECT_FALSE(matrix(a, b, a * u + b * v).inverse()) << i;
    EXPECT_FALSE(Affine(a * u + b * v, a, b, {}).inverse()) << i;
  }
}

TEST(Affine, ThatPressesAlmostFlatIsNotSingular) {
  Random random(8);
  for (const double least : {1e-3, 1e-9, 1e-12}) {
    for (int i = 0; i < 1000; ++i) {
      const Affine scaling = Affine::scaling({1, least, 1});
      const Affine before = Affine::rotation(random.direction(), random.between(-3, 3));
      const Affine after = Affine::rotation(random.direction(), random.between(-3, 3));
      EXPECT_TRUE((scaling * before).inverse()) << i;
      EXPECT_TRUE((after * scaling).inverse()) << i;
      EXPECT_TRUE((after * scaling * before).inverse()) << i;
    }
  }
  EXPECT_TRUE(Affine::scaling({1e-60, 1, 1e60}).inverse());
  EXPECT_TRUE((Affine::scaling({1, 1e-60, 1}) * Affine::rotation({1, 2, 3}, 1)).inverse());
  EXPECT_TRUE((Affine::rotation({1, 2, 3}, 1) * Affine::scaling({1, 1e-60, 1})).inverse());
}

TEST(Affine, NormalsStayOutsideWhereItMirrors) {
  const Affine mirror = Affine::scaling({-1, 2, 1});
  // The plane x + y = 0 becomes -x + y / 2 = 0.
  const Vec3d carried = normalized(mirror.normal({1, 1, 0}));
  expectNear(carried, normalized(Vec3d{-1, 0.5, 0}));
}

TEST(Affine, KnowsWhetherItKeepsAngles) {
  EXPECT_DOUBLE_EQ(*(Affine::rotation({1, 2, 3}, 0.7) * Affine::scaling({3, 3, -3})).uniformScale(),
                   3.0);
  EXPECT_FALSE(Affine::scaling({1, 1, 1.001}).uniformScale());
  EXPECT_FALSE(Affine({1, 0, 0}, {0.6, 0.8, 0}, {0, 0, 1}, {}).uniformScale());
  EXPECT_FALSE(Affine::scaling({0, 0, 0}).uniformScale());
}

}  // namespace
}  // namespace planetree::test
