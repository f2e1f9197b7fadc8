#include "unit/shape/shape_checks.hpp"

#include <planetree/shape/cone.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace planetree::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kHalfRoot = std::sqrt(0.5);

TEST(Cone, IsHitOnTheSideTwice) {
  const auto hits = allHits(Cone<double>{}, Rayd{{-5, 0, 0.25}, {1, 0, 0}});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].t, 4.25, 1e-15);
  EXPECT_NEAR(hits[0].normal.x, -kHalfRoot, 1e-15);
  EXPECT_NEAR(hits[0].normal.z, kHalfRoot, 1e-15);
  EXPECT_EQ(hits[0].part, kSidePart);
  EXPECT_EQ(hits[0].u, 0.5);
  EXPECT_NEAR(hits[0].v, 0.25, 1e-15);
  EXPECT_NEAR(hits[1].t, 5.75, 1e-15);
}

TEST(Cone, IsHitOnItsCaps) {
  const Cone<double> cutOff{{}, {0, 0, 2}, 3, 1};
  const auto hits = allHits(cutOff, Rayd{{0, -0.5, 5}, {0, 0, -1}});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].t, 3.0);
  EXPECT_EQ(hits[0].part, kTopCapPart);
  EXPECT_EQ(hits[0].v, 0.5);
  EXPECT_EQ(hits[0].u, 0.75);
  EXPECT_EQ(hits[1].t, 5.0);
  EXPECT_EQ(hits[1].part, kBaseCapPart);
  EXPECT_NEAR(hits[1].v, 0.5 / 3.0, 1e-15);
}

TEST(Cone, HasNoSecondNappe) {
  EXPECT_TRUE(allHits(Cone<double>{}, Rayd{{-5, 0, 1.5}, {1, 0, 0}}).empty());
  EXPECT_TRUE(
      allHits(Cone<double>{{}, {0, 0, 1}, 1, 0, false}, Rayd{{-5, 0, 2}, {1, 0, -0.1}}).empty());
  // Steeper than the side: from the other nappe through this one.
  const auto hits =
      allHits(Cone<double>{{}, {0, 0, 1}, 1, 0, false}, Rayd{{0.1, 0, 5}, {0, 0, -1}});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_NEAR(hits[0].t, 4.1, 1e-15);
}

TEST(Cone, IsHitAtItsApex) {
  const auto fromAbove = allHits(Cone<double>{}, Rayd{{0, 0, 5}, {0, 0, -1}});
  ASSERT_EQ(fromAbove.size(), 2u);
  EXPECT_EQ(fromAbove[0].t, 4.0);
  EXPECT_EQ(fromAbove[0].normal, (Vec3d{0, 0, 1}));
  EXPECT_EQ(fromAbove[1].t, 5.0);
  const Cone<double> upsideDown{{}, {0, 0, 1}, 0, 1};
  const auto fromBelow = allHits(upsideDown, Rayd{{0, 0, -2}, {0, 0, 0.5}});
  ASSERT_EQ(fromBelow.size(), 2u);
  EXPECT_EQ(fromBelow[0].t, 4.0);
  EXPECT_EQ(fromBelow[0].normal, (Vec3d{0, 0, -1}));
}

TEST(Cone, WithoutCapsIsNotMissedThroughItsApex) {
  const Cone<double> open{{0.1, 0.2, 0.3}, {0.3, -0.5, 0.7}, 0.1, 0, false};
  const Vec3d apex = open.base + open.axis;
  for (const Vec3d& aside : {Vec3d{0, 0, 0}, {0.01, 0.02, 0.005}, {-0.02, 0.001, 0.01}}) {
    const Vec3d eye = apex + open.axis + aside;
    EXPECT_FALSE(allHits(open, Rayd{eye, apex - eye}).empty());
  }
}

TEST(Cone, IsHitByRaysParallelToItsSide) {
  const auto solid = allHits(Cone<double>{}, Rayd{{0.5, 0, 0}, {-1, 0, 1}});
  ASSERT_EQ(solid.size(), 2u);
  EXPECT_EQ(solid[0].part, kBaseCapPart);
  EXPECT_EQ(solid[0].t, 0.0);
  EXPECT_EQ(solid[1].part, kSidePart);
  EXPECT_NEAR(solid[1].t, 0.75, 1e-15);
}

TEST(Cone, WithNearlyEqualRadiiIsNearlyACylinder) {
  for (const double excess : {0.0, 1e-16, 1e-15, 1e-12, 1e-8}) {
    for (const bool capped : {false, true}) {
      const Cone<double> cone{{}, {0, 0, 1}, 1, 1 + excess, capped};
      const auto hits = allHits(cone, Rayd{{-5, 0, 0.4}, {2, 0, 0.01}});
      ASSERT_EQ(hits.size(), 2u) << excess;
      EXPECT_NEAR(hits[0].t, 2.0, 1e-15 + excess);
      EXPECT_NEAR(hits[1].t, 3.0, 1e-15 + excess);
    }
  }
}

TEST(Cone, BoundsAreExactAlongTheAxes) {
  EXPECT_EQ((Cone<float>{}.bounds()), (Box3{{-1, -1, 0}, {1, 1, 1}}));
  EXPECT_EQ((Cone<float>{{1, 2, 3}, {0, -4, 0}, 1, 2}.bounds()), (Box3{{-1, -2, 1}, {3, 2, 5}}));
}

TEST(Cone, BoundsAreTightWhenSlanted) {
  const Box3 bounds = Cone<double>{{}, {4, 0, 3}, 1, 0}.bounds();
  EXPECT_NEAR(bounds.lower.x, -0.6f, 1e-6f);
  EXPECT_EQ(bounds.upper.x, 4.0f);
  EXPECT_NEAR(bounds.lower.z, -0.8f, 1e-6f);
  EXPECT_EQ(bounds.upper.z, 3.0f);
  EXPECT_EQ(bounds.upper.y, 1.0f);
}

TEST(Cone, CountsNegativeRadiiAsPositive) {
  const Rayd ray{{-5, 0.1, 0.5}, {1, 0.1, 0.05}};
  const Cone<double> positive{{}, {0, 0, 1}, 2, 1};
  const Cone<double> negative{{}, {0, 0, 1}, -2, -1};
  EXPECT_EQ(allHits(positive, ray).size(), 2u);
  EXPECT_EQ(allHits(positive, ray), allHits(negative, ray));
  EXPECT_EQ(positive.bounds(), negative.bounds());
}

TEST(Cone, WithNegativeHeightExtendsBelow) {
  const Cone<double> below{{}, {0, 0, -1}, 1, 0};
  const auto hits = allHits(below, Rayd{{-5, 0, -0.25}, {1, 0, 0}});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].t, 4.25, 1e-15);
  EXPECT_EQ(below.bounds(), (Box3{{-1, -1, -1}, {1, 1, 0}}));
}

TEST(Cone, WithoutSurfaceIsNothing) {
  for (const Cone<float>& cone :
       {Cone<float>{{}, {0, 0, 0}, 1, 0}, {{}, {0, 0, 1}, 0, 0}, {{}, {0, 0, 0}, 0, 0}}) {
    EXPECT_EQ(cone.bounds(), Box3{});
    EXPECT_TRUE(allHits(cone, Rayf{{0, 0, -1}, {0, 0, 1}}).empty());
    EXPECT_TRUE(allHits(cone, Rayf{{-1, 0, 0}, {1, 0, 0}}).empty());
  }
}

TEST(Cone, WithMembersThatAreNotFiniteIsNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {nan, kInfinity, -kInfinity}) {
    for (const Cone<double>& cone : {Cone<double>{{0, bad, 0}, {0, 0, 1}, 1, 0},
                                     {{}, {0, 0, bad}, 1, 0},
                                     {{}, {0, 0, 1}, bad, 0},
                                     {{}, {0, 0, 1}, 1, bad}}) {
      EXPECT_FALSE(isFinite(cone.bounds().lower));
      EXPECT_TRUE(allHits(cone, Rayd{{0, 0, -1}, {0, 0, 1}}).empty());
    }
  }
}

// A direction perpendicular to a slanted axis leaves a rounding residue along it: the line seems to
// meet the cone's slab, but very far off.
TEST(OpenCone, IsNotHitBeyondItsRimsByRaysAcrossASlantedAxis) {
  std::mt19937 random(3);
  const auto upTo = [&random](int most) {
    return static_cast<double>(random() % static_cast<unsigned>(most + 1));
  };
  const auto vector = [&upTo](int most) {
    return Vec3d{upTo(2 * most) - most, upTo(2 * most) - most, upTo(2 * most) - most};
  };
  int hits = 0;
  for (int i = 0; i < 300'000; ++i) {
    const Cone<double> cone{.base = {},
                            .axis = vector(3),
                            .bottomRadius = 1.0 + upTo(2),
                            .topRadius = upTo(3),
                            .capped = false};
    const Rayd ray{vector(4), vector(3)};
    if (dot(cone.axis, ray.direction) != 0.0 || cone.axis == Vec3d{} || ray.direction == Vec3d{})
      continue;
    const auto hit = cone.intersect(ray, -1e9, 1e9);
    if (!hit)
      continue;
    ++hits;
    const double height = dot(ray.at(hit->t), cone.axis) / dot(cone.axis, cone.axis);
    ASSERT_GT(height, -1e-9);
    ASSERT_LT(height, 1.0 + 1e-9);
  }
  EXPECT_GT(hits, 2'000);
}

}  // namespace
}  // namespace planetree::test
