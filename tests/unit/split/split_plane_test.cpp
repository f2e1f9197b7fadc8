#include <planetree/split/split_plane.hpp>

#include <planetree/split/find_best_split_plane.hpp>

#include "unit/split/random_references.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace planetree {
namespace {

using test::kReferenceStyles;
using test::ReferenceGenerator;
using test::ReferenceSet;
using test::ReferenceStyle;

constexpr std::uint32_t kSeed = 77'001;
constexpr PlanarRule kPlanarRules[] = {PlanarRule::CheaperSide, PlanarRule::NormalSign};
constexpr Side kSides[] = {Side::Left, Side::Right};

Reference xInterval(float lower, float upper, std::uint32_t leftSides = 0) {
  return {.bounds = {.lower = {lower, 0, 0}, .upper = {upper, 1, 1}},
          .object = 0,
          .leftSides = leftSides};
}

SplitPlane xPlane(float position, Side planarSide = Side::Right) {
  return {.axis = Axis::X, .position = position, .planarSide = planarSide};
}

/// Calls `check(reference, plane, rule)` for many references, each with planes through the ends of
/// others and beside them.
template <class Check>
void forManyPairs(const Check& check) {
  ReferenceGenerator generator(kSeed);
  for (const ReferenceStyle& style : kReferenceStyles) {
    const ReferenceSet set = generator.set(style, 20, 0.1);
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", " << style.name);
    for (const Reference& end : set.references) {
      for (const Axis axis : kAxes) {
        for (const float position :
             {end.bounds.lower[axis], end.bounds.upper[axis], nextUp(end.bounds.upper[axis])}) {
          for (const Side side : kSides) {
            const SplitPlane plane{.axis = axis, .position = position, .planarSide = side};
            for (const PlanarRule rule : kPlanarRules)
              check(set, plane, rule);
          }
        }
      }
    }
  }
}

TEST(CalculateLeftBBox, EndsAtThePlaneAndKeepsAllElse) {
  const Box3 cell = {.lower = {0, 1, 2}, .upper = {10, 11, 12}};
  const SplitPlane plane{.axis = Axis::Y, .position = 4.5f};
  EXPECT_EQ(calculateLeftBBox(plane, cell), (Box3{.lower = {0, 1, 2}, .upper = {10, 4.5f, 12}}));
}

TEST(CalculateRightBBox, BeginsAtThePlaneAndKeepsAllElse) {
  const Box3 cell = {.lower = {0, 1, 2}, .upper = {10, 11, 12}};
  const SplitPlane plane{.axis = Axis::Z, .position = 4.5f};
  EXPECT_EQ(calculateRightBBox(plane, cell), (Box3{.lower = {0, 1, 4.5f}, .upper = {10, 11, 12}}));
}

TEST(CalculateLeftBBox, IsFlatForAPlaneOnTheLowerWall) {
  const Box3 cell = {.lower = {0, 0, 0}, .upper = {1, 2, 3}};
  const Box3 left = calculateLeftBBox(xPlane(0.0f), cell);
  EXPECT_FALSE(left.isEmpty());
  EXPECT_EQ(left.surfaceArea(), 2.0 * 2.0 * 3.0);
  EXPECT_EQ(calculateRightBBox(xPlane(0.0f), cell), cell);
}

TEST(CalculateBBoxes, ShareThePlaneAndTogetherFillTheCell) {
  ReferenceGenerator generator(kSeed + 1);
  for (int round = 0; round < 200; ++round) {
    const Box3 cell = generator.cell(false, 0.1);
    for (const Axis axis : kAxes) {
      const float position =
          std::clamp(generator.between(-12.0f, 32.0f), cell.lower[axis], cell.upper[axis]);
      const SplitPlane plane{.axis = axis, .position = position};
      const Box3 left = calculateLeftBBox(plane, cell);
      const Box3 right = calculateRightBBox(plane, cell);
      EXPECT_EQ(left.upper[axis], right.lower[axis]);
      Box3 both = left;
      both.extend(right);
      EXPECT_EQ(both, cell);
      EXPECT_TRUE(contains(cell, left));
      EXPECT_TRUE(contains(cell, right));
    }
  }
}

TEST(GoesLeft, IsTrueForAPartBelowThePlane) {
  EXPECT_TRUE(goesLeft(xInterval(0, 1), xPlane(2), PlanarRule::CheaperSide));
  EXPECT_FALSE(goesRight(xInterval(0, 1), xPlane(2), PlanarRule::CheaperSide));
}

TEST(GoesLeft, IsFalseForWhatBeginsAtThePlane) {
  EXPECT_FALSE(goesLeft(xInterval(2, 3), xPlane(2), PlanarRule::CheaperSide));
  EXPECT_TRUE(goesRight(xInterval(2, 3), xPlane(2), PlanarRule::CheaperSide));
}

TEST(GoesRight, IsFalseForWhatEndsAtThePlane) {
  EXPECT_TRUE(goesLeft(xInterval(1, 2), xPlane(2), PlanarRule::CheaperSide));
  EXPECT_FALSE(goesRight(xInterval(1, 2), xPlane(2), PlanarRule::CheaperSide));
}

TEST(GoesLeft, FollowsThePlanarSideForWhatLiesInThePlane) {
  for (const std::uint32_t leftSides : {0u, 7u}) {
    const Reference planar = xInterval(2, 2, leftSides);
    EXPECT_TRUE(goesLeft(planar, xPlane(2, Side::Left), PlanarRule::CheaperSide));
    EXPECT_FALSE(goesRight(planar, xPlane(2, Side::Left), PlanarRule::CheaperSide));
    EXPECT_FALSE(goesLeft(planar, xPlane(2, Side::Right), PlanarRule::CheaperSide));
    EXPECT_TRUE(goesRight(planar, xPlane(2, Side::Right), PlanarRule::CheaperSide));
  }
}

TEST(GoesLeft, FollowsTheNormalUnderThatRule) {
  for (const Side side : kSides) {
    EXPECT_TRUE(goesLeft(xInterval(2, 2, 1), xPlane(2, side), PlanarRule::NormalSign));
    EXPECT_FALSE(goesRight(xInterval(2, 2, 1), xPlane(2, side), PlanarRule::NormalSign));
    // The other two axes of the normal have no say.
    EXPECT_FALSE(goesLeft(xInterval(2, 2, 6), xPlane(2, side), PlanarRule::NormalSign));
    EXPECT_TRUE(goesRight(xInterval(2, 2, 6), xPlane(2, side), PlanarRule::NormalSign));
  }
}

TEST(GoesLeftAndRight, LoseNoReference) {
  forManyPairs([](const ReferenceSet& set, const SplitPlane& plane, PlanarRule rule) {
    for (const Reference& reference : set.references)
      EXPECT_TRUE(goesLeft(reference, plane, rule) || goesRight(reference, plane, rule));
  });
}

TEST(GoesLeftAndRight, AreBothTrueForExactlyTheStraddlingReferences) {
  forManyPairs([](const ReferenceSet& set, const SplitPlane& plane, PlanarRule rule) {
    for (const Reference& reference : set.references) {
      const bool straddles = reference.bounds.lower[plane.axis] < plane.position &&
                             reference.bounds.upper[plane.axis] > plane.position;
      EXPECT_EQ(goesLeft(reference, plane, rule) && goesRight(reference, plane, rule), straddles);
    }
  });
}

TEST(CountObjects, CountsPlanarOnesOnceAndStraddlingOnesTwice) {
  forManyPairs([](const ReferenceSet& set, const SplitPlane& plane, PlanarRule rule) {
    std::size_t straddling = 0;
    for (const Reference& reference : set.references) {
      if (reference.bounds.lower[plane.axis] < plane.position &&
          reference.bounds.upper[plane.axis] > plane.position)
        ++straddling;
    }
    EXPECT_EQ(countLeftObjects(set.references, plane, rule) +
                  countRightObjects(set.references, plane, rule),
              set.references.size() + straddling);
  });
}

TEST(CountObjects, IsZeroWithoutReferences) {
  EXPECT_EQ(countLeftObjects({}, xPlane(0), PlanarRule::CheaperSide), 0u);
  EXPECT_EQ(countRightObjects({}, xPlane(0), PlanarRule::NormalSign), 0u);
}

TEST(Reference, TellsAxesOfTheNormalApart) {
  const Reference reference = xInterval(0, 1, 0b101);
  EXPECT_TRUE(reference.belongsLeft(Axis::X));
  EXPECT_FALSE(reference.belongsLeft(Axis::Y));
  EXPECT_TRUE(reference.belongsLeft(Axis::Z));
}

TEST(Reference, IsPlanarOnlyAlongFlatAxes) {
  EXPECT_TRUE(xInterval(2, 2).isPlanar(Axis::X));
  EXPECT_TRUE(xInterval(-0.0f, 0.0f).isPlanar(Axis::X));
  EXPECT_FALSE(xInterval(0, std::numeric_limits<float>::denorm_min()).isPlanar(Axis::X));
  EXPECT_FALSE(xInterval(2, 2).isPlanar(Axis::Y));
}

}  // namespace
}  // namespace planetree
