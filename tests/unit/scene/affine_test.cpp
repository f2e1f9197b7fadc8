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
