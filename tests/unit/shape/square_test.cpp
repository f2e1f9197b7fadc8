#include "unit/shape/shape_checks.hpp"

#include "support/random.hpp"

#include <planetree/shape/square.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace planetree::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Square, IsHitFromBothSidesWithOneNormal) {
  const Square<double> square;
  const auto fromBelow = square.intersect({{0.25, -0.25, -3}, {0, 0, 1}}, 0.0, kInfinity);
  const auto fromAbove = square.intersect({{0.25, -0.25, 3}, {0, 0, -1}}, 0.0, kInfinity);
  ASSERT_TRUE(fromBelow && fromAbove);
  EXPECT_EQ(fromBelow, fromAbove);
  EXPECT_EQ(fromBelow->t, 3.0);
  EXPECT_EQ(fromBelow->u, 0.75);
  EXPECT_EQ(fromBelow->v, 0.25);
  EXPECT_EQ(fromBelow->normal, (Vec3d{0, 0, 1}));
}

TEST(Square, IncludesItsEdges) {
  const Square<float> square;
  for (const float edge : {-0.5f, 0.5f}) {
    const auto hits = allHits(square, Rayf{{edge, 0.5f, 2}, {0, 0, -1}});
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].u, edge + 0.5f);
    EXPECT_EQ(hits[0].v, 1.0f);
  }
  EXPECT_TRUE(allHits(square, Rayf{{nextUp(0.5f), 0, 2}, {0, 0, -1}}).empty());
}

TEST(Square, MayBeAnyParallelogram) {
  const Square<double> slanted{{1, 2, 3}, {2, 0, 0}, {1, 3, 0}};
  const Vec3d point = Vec3d{1, 2, 3} + Vec3d{2, 0, 0} * 0.25 + Vec3d{1, 3, 0} * -0.4;
  const auto hits = allHits(slanted, Rayd{point + Vec3d{1, 1, 4}, {-1, -1, -4}});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_NEAR(hits[0].t, 1.0, 1e-15);
  EXPECT_NEAR(hits[0].u, 0.75, 1e-15);
  EXPECT_NEAR(hits[0].v, 0.1, 1e-15);
}

TEST(Square, IsMissedByRaysInItsPlane) {
  EXPECT_TRUE(allHits(Square<double>{}, Rayd{{-2, 0, 0}, {1, 0, 0}}).empty());
  EXPECT_TRUE(allHits(Square<double>{}, Rayd{{-2, 0, 1}, {1, 0, 0}}).empty());
}

TEST(Square, GrazedIsHitWithinItsEdges) {
  const Square<double> square;
  for (const double slope : {1e-3, 1e-8, 1e-14, 1e-100}) {
    const Rayd ray{{-2, 0.1, -2 * slope}, {1, 0, slope}};
    const auto hits = allHits(square, ray);
    ASSERT_EQ(hits.size(), 1u) << slope;
    EXPECT_LE(std::fabs(ray.at(hits[0].t).x), 0.5 + 1e-15);
  }
}

// u, v and t were far off where the edges are almost parallel.
TEST(Square, NarrowIsHitWhereUAndVSay) {
  Random random(7);
  const auto anyVector = [&random] { return random.pointIn<double>({-1, -1, -1}, {1, 1, 1}); };
  int hitCount = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Vec3d edgeU = anyVector();
    const Vec3d edgeV =
        edgeU * random.between(-2, 2) + anyVector() * std::exp2(random.between(-56, 0));
    const Square<double> square{anyVector(), edgeU, edgeV};
    const auto inside = [&](double u, double v) {
      return square.center + edgeU * (u - 0.5) + edgeV * (v - 0.5);
    };
    const Vec3d origin = anyVector() * 4.0;
    const Rayd ray{origin, inside(random.unit(), random.unit()) - origin, -kInfinity};
    for (const Hitd& hit : allHits(square, ray)) {
      ++hitCount;
      ASSERT_TRUE(hit.u >= 0.0 && hit.u <= 1.0 && hit.v >= 0.0 && hit.v <= 1.0);
      const Vec3d off = ray.at(hit.t) - inside(hit.u, hit.v);
      ASSERT_LE(length(off), 20 * 0x1p-53 * 8.0) << "number " << i;
    }
  }
  EXPECT_GT(hitCount, 150'000);
}

TEST(Square, BoundsAreFlatAndExactWhereTheyCanBe) {
  EXPECT_EQ((Square<float>{}.bounds()), (Box3{{-0.5, -0.5, 0}, {0.5, 0.5, 0}}));
  EXPECT_EQ((Square<double>{{0, 0, 1}, {2, 0, 2}, {1, 3, 0}}.bounds()),
            (Box3{{-1.5, -1.5, 0}, {1.5, 1.5, 2}}));
}

TEST(Square, ClippedBoundsCutOffTheCornersOfTheBox) {
  const Square<double> diamond{{}, {1, 1, 0}, {-1, 1, 0}};
  EXPECT_EQ(diamond.bounds(), (Box3{{-1, -1, 0}, {1, 1, 0}}));
  EXPECT_TRUE(diamond.clippedBounds({{0.6f, 0.6f, -1}, {1, 1, 1}}).isEmpty());
  const Box3 right = diamond.clippedBounds({{0.5, -1, -1}, {1, 1, 1}});
  EXPECT_NEAR(right.upper.y, 0.5f, 1e-6f);
  EXPECT_NEAR(right.lower.y, -0.5f, 1e-6f);
  EXPECT_EQ(right.upper.x, 1.0f);
}

TEST(Square, TellsTheSideOfItsPlane) {
  const Square<float> up;
  EXPECT_EQ(up.planarSide(Axis::Z), 1);
  EXPECT_EQ(up.planarSide(Axis::X), 0);
  const Square<float> down{{}, {0, 1, 0}, {1, 0, 0}};
  EXPECT_EQ(down.planarSide(Axis::Z), -1);
}

TEST(Square, WithoutAreaIsNothing) {
  for (const Square<double>& square :
       {Square<double>{{}, {0, 0, 0}, {0, 1, 0}}, {{}, {1, 2, 3}, {2, 4, 6}}}) {
    EXPECT_EQ(square.bounds(), Box3{});
    EXPECT_TRUE(square.clippedBounds({{-9, -9, -9}, {9, 9, 9}}).isEmpty());
    EXPECT_TRUE(allHits(square, Rayd{{0, 0, -1}, {0, 0, 1}}).empty());
    EXPECT_EQ(square.planarSide(Axis::Z), 0);
  }
}

TEST(Square, WithMembersThatAreNotFiniteIsNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {nan, kInfinity, -kInfinity}) {
    for (const Square<double>& square : {Square<double>{{bad, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                         {{}, {bad, 0, 0}, {0, 1, 0}},
                                         {{}, {1, 0, 0}, {0, bad, 0}}}) {
      EXPECT_FALSE(isFinite(square.bounds().lower));
      EXPECT_TRUE(square.clippedBounds({{-9, -9, -9}, {9, 9, 9}}).isEmpty());
      EXPECT_TRUE(allHits(square, Rayd{{0, 0, -1}, {0, 0, 1}}).empty());
    }
  }
}

}  // namespace
}  // namespace planetree::test
