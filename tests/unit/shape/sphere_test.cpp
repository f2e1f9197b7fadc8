#include "unit/shape/shape_checks.hpp"

#include <planetree/shape/sphere.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace planetree::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Sphere, IsHitInFrontAndBehind) {
  const Sphere<double> sphere;
  const auto hits = allHits(sphere, Rayd{{0, 0, -5}, {0, 0, 1}});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].t, 4.0);
  EXPECT_EQ(hits[0].normal, (Vec3d{0, 0, -1}));
  EXPECT_EQ(hits[1].t, 6.0);
  EXPECT_EQ(hits[1].normal, (Vec3d{0, 0, 1}));
  EXPECT_EQ(hits[0].part, 0u);
}

TEST(Sphere, FromInsideIsHitWhereTheRayLeaves) {
  const auto hit = Sphere<float>{}.intersect({{0, 0, 0}, {0, 2, 0}}, 0.0f, 100.0f);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 0.5f);
  EXPECT_EQ(hit->normal, (Vec3f{0, 1, 0}));
}

TEST(Sphere, BehindTheOriginIsHitOnlyWithNegativeTMin) {
  const Sphere<double> sphere;
  const Rayd ray{{0, 0, 5}, {0, 0, 1}};
  EXPECT_EQ(sphere.intersect(ray, 0.0, kInfinity), std::nullopt);
  EXPECT_EQ(sphere.intersect(ray, -5.0, kInfinity)->t, -4.0);
}

TEST(Sphere, TangentTouchesOnce) {
  const Sphere<double> sphere;
  for (const double length : {1.0, 3.0, 1e-12, 7e12}) {
    const auto hits = allHits(sphere, Rayd{{-5, 1, 0}, {length, 0, 0}});
    ASSERT_EQ(hits.size(), 1u) << length;
    EXPECT_EQ(hits[0].t, 5.0 / length);
    EXPECT_EQ(hits[0].normal, (Vec3d{0, 1, 0}));
  }
  EXPECT_TRUE(allHits(sphere, Rayd{{-5, nextUp(1.0), 0}, {1, 0, 0}}).empty());
}

TEST(Sphere, FarAwayIsAsRoundAsNearby) {
  const Sphere<double> sphere{{1e9, 0, 0}, 1.0};
  const Rayd ray{{1e9, 0.5, -1e6}, {0, 0, 1}};
  const auto hits = allHits(sphere, ray);
  ASSERT_EQ(hits.size(), 2u);
  const double halfChord = std::sqrt(0.75);
  EXPECT_NEAR(hits[0].t, 1e6 - halfChord, 1e6 * 0x1p-52);
  EXPECT_NEAR(hits[1].t, 1e6 + halfChord, 1e6 * 0x1p-52);
  EXPECT_NEAR(hits[0].normal.z, -halfChord, 1e-9);
}

TEST(Sphere, TellsLongitudeAndLatitude) {
  const auto seenFrom = [](const Vec3d& eye) {
    return *Sphere<double>{}.intersect({eye, -eye}, 0.0, kInfinity);
  };
  EXPECT_EQ(seenFrom({2, 0, 0}).u, 0.0);
  EXPECT_EQ(seenFrom({2, 0, 0}).v, 0.5);
  EXPECT_EQ(seenFrom({0, 2, 0}).u, 0.25);
  EXPECT_EQ(seenFrom({-2, 0, 0}).u, 0.5);
  EXPECT_EQ(seenFrom({0, -2, 0}).u, 0.75);
  EXPECT_EQ(seenFrom({0, 0, -2}).v, 0.0);
  EXPECT_EQ(seenFrom({0, 0, 2}).v, 1.0);
  EXPECT_NEAR(seenFrom({2, 2, std::sqrt(8.0)}).u, 0.125, 1e-15);
  EXPECT_NEAR(seenFrom({2, 2, std::sqrt(8.0)}).v, 0.75, 1e-15);
}

TEST(Sphere, CountsANegativeRadiusAsPositive) {
  const Rayd ray{{0.1, 0.2, -5}, {0, 0, 1}};
  EXPECT_EQ(allHits(Sphere<double>{{}, -2}, ray), allHits(Sphere<double>{{}, 2}, ray));
  EXPECT_EQ((Sphere<double>{{}, -2}.bounds()), (Sphere<double>{{}, 2}.bounds()));
}

TEST(Sphere, OfRadiusZeroIsNothing) {
  const Sphere<float> point{{1, 2, 3}, 0};
  EXPECT_EQ(point.bounds(), Box3{});
  EXPECT_TRUE(point.clippedBounds({{0, 0, 0}, {9, 9, 9}}).isEmpty());
  EXPECT_TRUE(allHits(point, Rayf{{1, 2, 0}, {0, 0, 1}}).empty());
}

TEST(Sphere, WithMembersThatAreNotFiniteIsNothing) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (const Sphere<double>& sphere : {Sphere<double>{{bad, 0, 0}, 1}, Sphere<double>{{}, bad}}) {
      EXPECT_FALSE(isFinite(sphere.bounds().lower));
      EXPECT_TRUE(sphere.bounds().isEmpty());
      EXPECT_TRUE(sphere.clippedBounds({{-9, -9, -9}, {9, 9, 9}}).isEmpty());
      EXPECT_TRUE(allHits(sphere, Rayd{{0, 0, -5}, {0, 0, 1}}).empty());
    }
  }
}

TEST(Sphere, BoundsAreExactWhereTheyCanBe) {
  EXPECT_EQ((Sphere<float>{}.bounds()), (Box3{{-1, -1, -1}, {1, 1, 1}}));
  EXPECT_EQ((Sphere<double>{{1, 2, 3}, 0.5}.bounds()), (Box3{{0.5, 1.5, 2.5}, {1.5, 2.5, 3.5}}));
}

TEST(Sphere, BoundsAreRoundedOutward) {
  // The exact bounds round to the centre both in double and in float.
  const Box3 bounds = Sphere<double>{{1, 1, 1}, 0x1p-60}.bounds();
  EXPECT_LT(bounds.lower.x, 1.0f);
  EXPECT_GT(bounds.upper.x, 1.0f);
  EXPECT_EQ(bounds.lower.x, nextDown(1.0f));
}

TEST(Sphere, IsAbsentFromCellsWithinItAndBesideIt) {
  const Sphere<double> sphere;
  EXPECT_TRUE(sphere.clippedBounds({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}).isEmpty());
  EXPECT_TRUE(sphere.clippedBounds({{0.6f, 0.6f, 0.6f}, {1, 1, 1}}).isEmpty());
  EXPECT_TRUE(sphere.clippedBounds({{2, 2, 2}, {3, 3, 3}}).isEmpty());
  const Box3 touching = sphere.clippedBounds({{1, -1, -1}, {2, 1, 1}});
  ASSERT_FALSE(touching.isEmpty());
  EXPECT_EQ(touching.lower.x, 1.0f);
  EXPECT_NEAR(touching.upper.y, 0.0f, 1e-6f);
}

TEST(Sphere, ClippedBoundsFollowTheCurve) {
  const Box3 cap = Sphere<double>{}.clippedBounds({{0.5, -1, -1}, {1, 1, 1}});
  EXPECT_EQ(cap.lower.x, 0.5f);
  EXPECT_EQ(cap.upper.x, 1.0f);
  EXPECT_NEAR(cap.upper.y, std::sqrt(0.75), 1e-6);
  EXPECT_NEAR(cap.lower.z, -std::sqrt(0.75), 1e-6);
}

}  // namespace
}  // namespace planetree::test
