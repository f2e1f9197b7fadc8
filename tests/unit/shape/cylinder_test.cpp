#include "unit/shape/shape_checks.hpp"

#include <planetree/shape/cylinder.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace planetree::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Cylinder, IsHitOnTheSideTwice) {
  const Cylinder<double> cylinder;
  const auto hits = allHits(cylinder, Rayd{{-5, 0, 0.25}, {1, 0, 0}});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].t, 4.0);
  EXPECT_EQ(hits[0].normal, (Vec3d{-1, 0, 0}));
  EXPECT_EQ(hits[0].part, kSidePart);
  EXPECT_EQ(hits[0].u, 0.5);
  EXPECT_EQ(hits[0].v, 0.25);
  EXPECT_EQ(hits[1].t, 6.0);
  EXPECT_EQ(hits[1].u, 0.0);
}

TEST(Cylinder, IsHitOnItsCaps) {
  const Cylinder<float> cylinder;
  const auto hits = allHits(cylinder, Rayf{{0, 0.5f, 3}, {0, 0, -1}});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].t, 2.0f);
  EXPECT_EQ(hits[0].part, kTopCapPart);
  EXPECT_EQ(hits[0].normal, (Vec3f{0, 0, 1}));
  EXPECT_EQ(hits[0].u, 0.25f);
  EXPECT_EQ(hits[0].v, 0.5f);
  EXPECT_EQ(hits[1].t, 3.0f);
  EXPECT_EQ(hits[1].part, kBaseCapPart);
  EXPECT_EQ(hits[1].normal, (Vec3f{0, 0, -1}));
}

TEST(Cylinder, WithoutCapsIsOpen) {
  const Cylinder<double> open{{}, {0, 0, 1}, 1, false};
  EXPECT_TRUE(allHits(open, Rayd{{0, 0.5, 3}, {0, 0, -1}}).empty());
  // In through the open top, out through the side.
  const auto hits = allHits(open, Rayd{{0, 0, 1.5}, {1, 0, -1}});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].normal, (Vec3d{1, 0, 0}));
}

TEST(Cylinder, TangentTouchesOnce) {
  for (const bool capped : {false, true}) {
    const Cylinder<double> cylinder{{}, {0, 0, 1}, 1, capped};
    EXPECT_EQ(allHits(cylinder, Rayd{{-5, 1, 0.5}, {1, 0, 0}}).size(), 1u);
    EXPECT_TRUE(allHits(cylinder, Rayd{{-5, nextUp(1.0), 0.5}, {1, 0, 0}}).empty());
  }
}

TEST(Cylinder, IsHitThroughItsRims) {
  const Cylinder<double> cylinder;
  EXPECT_EQ(allHits(cylinder, Rayd{{-2, 0, 2}, {1, 0, -1}}).size(), 2u);
  EXPECT_EQ(allHits(cylinder, Rayd{{0, 0, 0.5}, {2, 0, 1}}, 0.0).size(), 1u);
  const Rayd alongSide{{1, 0, -1}, {0, 0, 1}};
  EXPECT_EQ(allHits(cylinder, alongSide).size(), 2u) << "the closed solid holds the line";
  const Rayd inCap{{-3, 0, 1}, {1, 0, 0}};
  EXPECT_EQ(allHits(cylinder, inCap).size(), 2u);
}

TEST(Cylinder, WithoutCapsIsMissedByRaysWithinTheSide) {
  const Cylinder<double> open{{}, {0, 0, 1}, 1, false};
  EXPECT_TRUE(allHits(open, Rayd{{1, 0, -1}, {0, 0, 1}}).empty());
}

TEST(Cylinder, MayBeSlanted) {
  const Vec3d axis{1, 1, 0};
  const Cylinder<double> cylinder{{1, 0, 0}, axis, 0.5, true};
  const Vec3d middle = cylinder.base + axis * 0.5;
  const auto hits = allHits(cylinder, Rayd{middle + Vec3d{0, 0, 2}, {0, 0, -1}});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].t, 1.5, 1e-15);
  EXPECT_NEAR(hits[1].t, 2.5, 1e-15);
  EXPECT_NEAR(hits[0].v, 0.5, 1e-15);
  const auto capHits = allHits(cylinder, Rayd{middle - axis * 2.0, axis});
  ASSERT_EQ(capHits.size(), 2u);
  EXPECT_NEAR(capHits[0].t, 1.5, 1e-15);
  EXPECT_EQ(capHits[0].part, kBaseCapPart);
  EXPECT_EQ(capHits[1].part, kTopCapPart);
}

TEST(Cylinder, BoundsAreExactAlongTheAxes) {
  EXPECT_EQ((Cylinder<float>{}.bounds()), (Box3{{-1, -1, 0}, {1, 1, 1}}));
  EXPECT_EQ((Cylinder<float>{{1, 2, 3}, {-4, 0, 0}, 2}.bounds()), (Box3{{-3, 0, 1}, {1, 4, 5}}));
}

TEST(Cylinder, BoundsAreTightWhenSlanted) {
  const Box3 bounds = Cylinder<double>{{}, {1, 1, 0}, 1}.bounds();
  const auto reach = static_cast<float>(std::sqrt(0.5));
  EXPECT_NEAR(bounds.lower.x, -reach, 1e-6f);
  EXPECT_NEAR(bounds.upper.y, 1.0f + reach, 1e-6f);
  EXPECT_EQ(bounds.lower.z, -1.0f);
  EXPECT_EQ(bounds.upper.z, 1.0f);
}

TEST(Cylinder, CountsANegativeRadiusAsPositive) {
  const Rayd ray{{-5, 0.1, 0.5}, {1, 0.1, 0.05}};
  const Cylinder<double> positive{{}, {0, 0, 1}, 2};
  const Cylinder<double> negative{{}, {0, 0, 1}, -2};
  EXPECT_EQ(allHits(positive, ray).size(), 2u);
  EXPECT_EQ(allHits(positive, ray), allHits(negative, ray));
  EXPECT_EQ(positive.bounds(), negative.bounds());
}

TEST(Cylinder, WithoutSurfaceIsNothing) {
  for (const Cylinder<double>& cylinder :
       {Cylinder<double>{{}, {0, 0, 0}, 1}, {{}, {0, 0, 1}, 0}, {{}, {0, 0, 0}, 0}}) {
    EXPECT_EQ(cylinder.bounds(), Box3{});
    EXPECT_TRUE(allHits(cylinder, Rayd{{0, 0, -1}, {0, 0, 1}}).empty());
    EXPECT_TRUE(allHits(cylinder, Rayd{{-1, 0, 0}, {1, 0, 0}}).empty());
  }
}

TEST(Cylinder, WithMembersThatAreNotFiniteIsNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {nan, kInfinity, -kInfinity}) {
    for (const Cylinder<double>& cylinder : {Cylinder<double>{{0, bad, 0}, {0, 0, 1}, 1},
                                             {{}, {0, 0, bad}, 1},
                                             {{}, {0, 0, 1}, bad}}) {
      EXPECT_FALSE(isFinite(cylinder.bounds().lower));
      EXPECT_TRUE(allHits(cylinder, Rayd{{0, 0, -1}, {0, 0, 1}}).empty());
    }
  }
}

}  // namespace
}  // namespace planetree::test
