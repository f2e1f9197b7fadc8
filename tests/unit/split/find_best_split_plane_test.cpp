#include <planetree/split/find_best_split_plane.hpp>

#include "support/sorting_oracle.hpp"
#include "support/textbook_oracle.hpp"
#include "unit/split/random_references.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace planetree {
namespace {

using test::kReferenceStyles;
using test::OraclePlane;
using test::ReferenceGenerator;
using test::ReferenceSet;
using test::ReferenceStyle;

constexpr std::uint32_t kSeed = 20'240'601;

struct NamedOptions {
  const char* name;
  BuildOptions options;
};

std::vector<NamedOptions> optionSets() {
  std::vector<NamedOptions> sets = {{"defaults", {}}, {"textbook", BuildOptions::textbook()}};
  BuildOptions options;
  options.planarRule = PlanarRule::NormalSign;
  sets.push_back({"defaults with normals", options});
  options = BuildOptions::textbook();
  options.planarRule = PlanarRule::CheaperSide;
  sets.push_back({"textbook with the cheaper side", options});
  options = BuildOptions::textbook();
  options.allowsEmptyCells = true;
  sets.push_back({"textbook with empty cells", options});
  options = {};
  options.allowsEmptyCells = false;
  sets.push_back({"defaults without empty cells", options});
  options = {};
  options.cost = {.traversalCost = 0.0, .intersectionCost = 0.0, .emptyBonus = 0.0};
  sets.push_back({"free of cost", options});
  options = {};
  options.cost = {.traversalCost = 20.0, .intersectionCost = 0.125, .emptyBonus = 0.99};
  sets.push_back({"dear traversal, large bonus", options});
  return sets;
}

void expectEqual(const std::optional<SplitPlane>& found, const std::optional<OraclePlane>& wanted) {
  ASSERT_EQ(found.has_value(), wanted.has_value());
  if (!found)
    return;
  EXPECT_EQ(found->axis, wanted->axis);
  EXPECT_EQ(found->position, wanted->position);
  EXPECT_EQ(found->leftCount, wanted->leftCount);
  EXPECT_EQ(found->rightCount, wanted->rightCount);
  EXPECT_EQ(found->planarSide, wanted->planarSide);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(found->cost), std::bit_cast<std::uint64_t>(wanted->cost))
      << found->cost << " and " << wanted->cost;
}

void expectOraclesPlane(const ReferenceSet& set, const BuildOptions& options) {
  expectEqual(findBestSplitPlane(set.references, set.cell, options),
              test::findBestSplitPlaneByCounting(set.references, set.cell, options));
}

std::vector<Box3*> boxesOf(ReferenceSet& set) {
  std::vector<Box3*> boxes = {&set.cell};
  for (Reference& reference : set.references)
    boxes.push_back(&reference.bounds);
  return boxes;
}

Reference box(Vec3f lower, Vec3f upper, std::uint32_t leftSides = 0) {
  return {.bounds = {.lower = lower, .upper = upper}, .object = 0, .leftSides = leftSides};
}

const Box3 kCube = {.lower = {0, 0, 0}, .upper = {4, 4, 4}};

TEST(FindBestSplitPlane, IsThatOfTheOracleOnRandomSets) {
  ReferenceGenerator generator(kSeed);
  for (const NamedOptions& named : optionSets()) {
    for (const ReferenceStyle& style : kReferenceStyles) {
      for (int round = 0; round < 120; ++round) {
        const ReferenceSet set = generator.set(style, 1 + generator.below(24), 0.05);
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", " << named.name << ", "
                                        << style.name << ", round " << round);
        expectOraclesPlane(set, named.options);
        if (HasFailure())
          return;
      }
    }
  }
}

TEST(FindBestSplitPlane, IsThatOfTheOracleOnLargerSets) {
  ReferenceGenerator generator(kSeed + 1);
  for (const NamedOptions& named : optionSets()) {
    for (const ReferenceStyle& style : kReferenceStyles) {
      const ReferenceSet set = generator.set(style, 150, 0.0);
      SCOPED_TRACE(testing::Message()
                   << "seed " << kSeed + 1 << ", " << named.name << ", " << style.name);
      expectOraclesPlane(set, named.options);
    }
  }
}

TEST(FindBestSplitPlane, IsThatOfASweepOverAllEnds) {
  ReferenceGenerator generator(kSeed + 5);
  for (const NamedOptions& named : optionSets()) {
    for (const ReferenceStyle& style : kReferenceStyles) {
      for (const std::size_t count : {15u, 16u, 17u, 255u, 256u, 1000u, 3000u}) {
        const ReferenceSet set = generator.set(style, count, 0.05);
        SCOPED_TRACE(testing::Message() << "seed " << kSeed + 5 << ", " << named.name << ", "
                                        << style.name << ", " << count << " references");
        expectEqual(findBestSplitPlane(set.references, set.cell, named.options),
                    test::findBestSplitPlaneBySorting(set.references, set.cell, named.options));
        if (HasFailure())
          return;
      }
    }
  }
}

// Large enough for all threads to search together.
TEST(FindBestSplitPlane, IsThatOfASweepOverAllEndsOfLargeCells) {
  ReferenceGenerator generator(kSeed + 6);
  for (const BuildOptions& options : {BuildOptions{}, BuildOptions::textbook()}) {
    for (const ReferenceStyle& style : kReferenceStyles) {
      const ReferenceSet set = generator.set(style, 80'000, 0.0);
      SCOPED_TRACE(testing::Message() << "seed " << kSeed + 6 << ", " << style.name);
      expectEqual(findBestSplitPlane(set.references, set.cell, options),
                  test::findBestSplitPlaneBySorting(set.references, set.cell, options));
      if (HasFailure())
        return;
    }
  }
}

// Bins bound costs by the areas at their edges: those of extreme cells must not mislead them.
TEST(FindBestSplitPlane, IsThatOfASweepAtAllScales) {
  ReferenceGenerator generator(kSeed + 7);
  for (const float scale : {0x1p-120f, 0x1p-40f, 0x1p-10f, 0x1p20f, 0x1p60f, 0x1p120f}) {
    for (const ReferenceStyle& style : kReferenceStyles) {
      ReferenceSet set = generator.set(style, 300, 0.3);
      for (Box3* box : boxesOf(set)) {
        box->lower = box->lower * scale;
        box->upper = box->upper * scale;
      }
      SCOPED_TRACE(testing::Message()
                   << "seed " << kSeed + 7 << ", " << style.name << ", times " << scale);
      expectEqual(findBestSplitPlane(set.references, set.cell, {}),
                  test::findBestSplitPlaneBySorting(set.references, set.cell, {}));
    }
  }
}

TEST(FindBestSplitPlane, IsThatOfTheOracleInFlatCells) {
  ReferenceGenerator generator(kSeed + 2);
  for (const NamedOptions& named : optionSets()) {
    for (const ReferenceStyle& style : kReferenceStyles) {
      for (int round = 0; round < 40; ++round) {
        const ReferenceSet set = generator.set(style, 1 + generator.below(12), 0.6);
        SCOPED_TRACE(testing::Message() << "seed " << kSeed + 2 << ", " << named.name << ", "
                                        << style.name << ", round " << round);
        expectOraclesPlane(set, named.options);
        if (HasFailure())
          return;
      }
    }
  }
}

// The taught rule divides once by A, the library divides each area: equal but for rounding. With
// small integers, sums of counts times areas are exact, and different ones lie far apart.
TEST(FindBestSplitPlane, HasTheSmallestSamUnderTheTextbookRules) {
  ReferenceGenerator generator(kSeed + 3);
  const BuildOptions options = BuildOptions::textbook();
  for (const ReferenceStyle& style : kReferenceStyles) {
    for (int round = 0; round < 200; ++round) {
      const ReferenceSet set = generator.set(style, 1 + generator.below(24), 0.0);
      SCOPED_TRACE(testing::Message()
                   << "seed " << kSeed + 3 << ", " << style.name << ", round " << round);
      const auto wanted = test::findTextbookPlane(set.references, set.cell);
      const auto found = findBestSplitPlane(set.references, set.cell, options);
      ASSERT_EQ(found.has_value(), wanted.has_value());
      if (!found)
        continue;
      const double sam =
          test::textbookPlane(set.references, set.cell, found->axis, found->position).sam;
      const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * wanted->sam;
      EXPECT_LE(sam, wanted->sam + (style.hasIntegerCoordinates ? 0.0 : rounding));
      EXPECT_NEAR(found->cost, sam, rounding);
      if (HasFailure())
        return;
    }
  }
}

TEST(FindBestSplitPlane, DoesNotDependOnTheOrderOfTheReferences) {
  ReferenceGenerator generator(kSeed + 4);
  std::mt19937 shuffler(kSeed);
  for (const NamedOptions& named : optionSets()) {
    for (const ReferenceStyle& style : kReferenceStyles) {
      for (int round = 0; round < 20; ++round) {
        ReferenceSet set = generator.set(style, 2 + generator.below(30), 0.1);
        const auto before = findBestSplitPlane(set.references, set.cell, named.options);
        std::shuffle(set.references.begin(), set.references.end(), shuffler);
        const auto after = findBestSplitPlane(set.references, set.cell, named.options);
        SCOPED_TRACE(testing::Message() << "seed " << kSeed + 4 << ", " << named.name << ", "
                                        << style.name << ", round " << round);
        ASSERT_EQ(before.has_value(), after.has_value());
        if (!before)
          continue;
        EXPECT_EQ(before->axis, after->axis);
        EXPECT_EQ(before->position, after->position);
        EXPECT_EQ(before->planarSide, after->planarSide);
        EXPECT_EQ(before->leftCount, after->leftCount);
        EXPECT_EQ(before->rightCount, after->rightCount);
        EXPECT_EQ(before->cost, after->cost);
        if (HasFailure())
          return;
      }
    }
  }
}

TEST(FindBestSplitPlane, IsNothingWithoutReferences) {
  EXPECT_FALSE(findBestSplitPlane({}, kCube, {}));
  EXPECT_FALSE(findBestSplitPlane({}, kCube, BuildOptions::textbook()));
}

TEST(FindBestSplitPlane, IsNothingWhereAllBoxesFillTheCell) {
  const std::vector<Reference> references(5, box(kCube.lower, kCube.upper));
  EXPECT_FALSE(findBestSplitPlane(references, kCube, {}));
}

TEST(FindBestSplitPlane, IsNothingInACellThatIsAPoint) {
  const Box3 point = {.lower = {1, 2, 3}, .upper = {1, 2, 3}};
  const std::vector<Reference> references(3, box(point.lower, point.upper));
  EXPECT_FALSE(findBestSplitPlane(references, point, {}));
}

TEST(FindBestSplitPlane, IsNothingWhereAllEndsLieOutsideTheCell) {
  const std::vector<Reference> references(3, box({-1, -1, -1}, {5, 5, 5}));
  EXPECT_FALSE(findBestSplitPlane(references, kCube, {}));
  EXPECT_FALSE(findBestSplitPlane(references, kCube, BuildOptions::textbook()));
}

TEST(FindBestSplitPlane, CutsOffEmptySpaceAroundASingleReference) {
  const std::vector<Reference> references = {box({0, 0, 3}, {4, 4, 4})};
  const auto plane = findBestSplitPlane(references, kCube, {});
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->axis, Axis::Z);
  EXPECT_EQ(plane->position, 3.0f);
  EXPECT_EQ(plane->leftCount, 0u);
  EXPECT_EQ(plane->rightCount, 1u);
}

TEST(FindBestSplitPlane, TakesPlanesOnTheWallsOnlyWithoutEmptyCells) {
  const std::vector<Reference> references = {box({0, 0, 0}, {4, 4, 4})};
  BuildOptions options;
  EXPECT_FALSE(findBestSplitPlane(references, kCube, options));
  options.allowsEmptyCells = false;
  const auto plane = findBestSplitPlane(references, kCube, options);
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->axis, Axis::X);
  EXPECT_EQ(plane->position, 0.0f);
}

TEST(FindBestSplitPlane, BreaksEqualCostsByAxisThenByTheLowerPosition) {
  // Eight cubes in the corners: the six planes at 1 and 3 of all axes cost the same.
  std::vector<Reference> references;
  for (const float x : {0.0f, 3.0f}) {
    for (const float y : {0.0f, 3.0f}) {
      for (const float z : {0.0f, 3.0f})
        references.push_back(box({x, y, z}, {x + 1, y + 1, z + 1}));
    }
  }
  const auto plane = findBestSplitPlane(references, kCube, {});
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->axis, Axis::X);
  EXPECT_EQ(plane->position, 1.0f);
}

TEST(FindBestSplitPlane, PutsPlanarObjectsOnTheCheaperSideWhateverTheirNormal) {
  for (const std::uint32_t leftSides : {0u, 7u}) {
    // A sheet at 1: on the left it shares the small cell, on the right the large one.
    const std::vector<Reference> references = {box({1, 0, 0}, {1, 4, 4}, leftSides)};
    const auto plane = findBestSplitPlane(references, kCube, {});
    ASSERT_TRUE(plane);
    EXPECT_EQ(plane->position, 1.0f);
    EXPECT_EQ(plane->planarSide, Side::Left);
    EXPECT_EQ(plane->leftCount, 1u);
    EXPECT_EQ(plane->rightCount, 0u);
  }
}

TEST(FindBestSplitPlane, PutsPlanarObjectsOnTheRightWhereBothSidesCostTheSame) {
  const std::vector<Reference> references = {box({2, 0, 0}, {2, 4, 4}, 7u)};
  const auto plane = findBestSplitPlane(references, kCube, {});
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->position, 2.0f);
  EXPECT_EQ(plane->planarSide, Side::Right);
}

TEST(FindBestSplitPlane, PutsPlanarObjectsWhereTheirNormalsPointUnderThatRule) {
  BuildOptions options;
  options.planarRule = PlanarRule::NormalSign;
  const std::vector<Reference> references = {box({2, 0, 0}, {2, 4, 4}, 1u),
                                             box({2, 0, 0}, {2, 4, 4}, 6u)};
  const auto plane = findBestSplitPlane(references, kCube, options);
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->leftCount, 1u);
  EXPECT_EQ(plane->rightCount, 1u);
}

TEST(FindBestSplitPlane, WorksAtTheEndsOfTheRangeOfFloat) {
  constexpr float kHuge = std::numeric_limits<float>::max();
  constexpr float kTiny = std::numeric_limits<float>::denorm_min();
  for (const float size : {kHuge, kTiny}) {
    const Box3 cell = {.lower = {-size, -size, -size}, .upper = {size, size, size}};
    const std::vector<Reference> references = {box({-size, -size, -size}, {0, size, size}),
                                               box({0, -size, -size}, {size, size, size})};
    const auto plane = findBestSplitPlane(references, cell, {});
    ASSERT_TRUE(plane);
    EXPECT_EQ(plane->axis, Axis::X);
    EXPECT_EQ(plane->position, 0.0f);
    EXPECT_EQ(plane->leftCount, 1u);
    EXPECT_EQ(plane->rightCount, 1u);
    EXPECT_TRUE(std::isfinite(plane->cost));
  }
}

TEST(FindBestSplitPlane, GivesTheSameBitsForBothZerosInAnyOrder) {
  const Box3 cell = {.lower = {-1, 0, 0}, .upper = {1, 1, 1}};
  const std::vector<Reference> positiveFirst = {box({-1, 0, 0}, {0.0f, 1, 1}),
                                                box({-1, 0, 0}, {-0.0f, 1, 1})};
  const std::vector<Reference> negativeFirst = {positiveFirst[1], positiveFirst[0]};
  const auto plane = findBestSplitPlane(positiveFirst, cell, {});
  const auto same = findBestSplitPlane(negativeFirst, cell, {});
  ASSERT_TRUE(plane && same);
  EXPECT_EQ(std::signbit(plane->position), std::signbit(same->position));
}

TEST(FindBestSplitPlane, TakesBothZerosForOnePosition) {
  const Box3 cell = {.lower = {-1, -1, -1}, .upper = {1, 1, 1}};
  const std::vector<Reference> references = {
      box({-0.0f, -1, -1}, {0.0f, 1, 1}), box({0.0f, -1, -1}, {-0.0f, 1, 1}),
      box({-1, -1, -1}, {-0.0f, 1, 1}), box({0.0f, -1, -1}, {1, 1, 1})};
  const auto plane = findBestSplitPlane(references, cell, {});
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->position, 0.0f);
  EXPECT_EQ(plane->leftCount, 1u);
  EXPECT_EQ(plane->rightCount, 3u);
}

}  // namespace
}  // namespace planetree
