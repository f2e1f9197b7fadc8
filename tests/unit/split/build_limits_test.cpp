#include <planetree/build_tree.hpp>
#include <planetree/error.hpp>
#include <planetree/node/validate_tree.hpp>

#include "unit/split/random_meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace planetree {
namespace {

using test::MeshGenerator;

constexpr std::uint32_t kSeed = 271'828;

TriangleMesh<float> copiesOfOneFace(std::size_t count) {
  TriangleMesh<float> mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0.5f}, {0, 1, 0.25f}};
  mesh.faces.assign(count, {0, 1, 2});
  return mesh;
}

template <class O>
void expectValid(const KdTree<O>& tree) {
  const auto problem =
      validateTree(tree.nodes(), tree.view().references, tree.bounds(), tree.objectCount());
  EXPECT_FALSE(problem) << *problem;
}

/// The number of references of each leaf, from left to right.
template <class O>
std::vector<std::uint32_t> leafCounts(const KdTree<O>& tree) {
  std::vector<std::uint32_t> counts;
  for (const Node& node : tree.nodes()) {
    if (node.isLeaf())
      counts.push_back(node.leaf().count());
  }
  return counts;
}

TEST(LeafCounts, AreExactForAMillionCopiesOfOneFace) {
  constexpr std::uint32_t kCopyCount = 1'000'000;
  const auto tree = buildTree(copiesOfOneFace(kCopyCount));
  ASSERT_EQ(tree.nodes().size(), 1u);
  ASSERT_EQ(tree.root().leaf().count(), kCopyCount);
  const auto references = tree.references(tree.root().leaf());
  for (std::uint32_t i = 0; i < kCopyCount; ++i)
    ASSERT_EQ(references[i], i);
}

TEST(LeafCounts, AreExactForManyCopiesUnderAllStoppingRules) {
  BuildOptions options = BuildOptions::textbook();
  EXPECT_EQ(buildTree(copiesOfOneFace(70'000), options).root().leaf().count(), 70'000u);
  options = {};
  options.stopsByCost = false;
  options.leafSize = 0;
  EXPECT_EQ(buildTree(copiesOfOneFace(70'000), options).statistics().largestLeaf, 70'000u);
}

/// Flat ground with a mast on it.
TriangleMesh<float> groundWithMast(int side) {
  TriangleMesh<float> mesh;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x)
      mesh.positions.push_back({static_cast<float>(x), static_cast<float>(y), 0.0f});
  }
  const auto vertex = [&](int x, int y) { return static_cast<std::uint32_t>(y * (side + 1) + x); };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      mesh.faces.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)});
      mesh.faces.push_back({vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
    }
  }
  const auto mast = static_cast<std::uint32_t>(mesh.positions.size());
  const auto middle = static_cast<float>(side) / 2.0f;
  mesh.positions.insert(mesh.positions.end(), {{middle, middle, 0},
                                               {middle + 0.5f, middle, 0},
                                               {middle, middle, static_cast<float>(side)}});
  mesh.faces.push_back({mast, mast + 1, mast + 2});
  return mesh;
}

// The cheapest edge of the bins is one that cuts off the air above, where no face ends.
TEST(LeafCounts, StaySmallOnFlatGroundUnderAMast) {
  for (BuildOptions options : {BuildOptions::fast(), BuildOptions::balanced()}) {
    const auto tree = buildTree(groundWithMast(100), options);
    EXPECT_LT(tree.statistics().largestLeaf, 1000u);
    expectValid(tree);
  }
}

TEST(LeafCounts, AddUpToTheReferencesOfTheTree) {
  MeshGenerator generator(kSeed);
  const auto tree = buildTree(generator.soupOfAnyCoordinates<float>(2000, 0.2f));
  std::uint64_t sum = 0;
  for (const std::uint32_t count : leafCounts(tree))
    sum += count;
  EXPECT_EQ(sum, tree.view().references.size());
  EXPECT_EQ(sum, tree.statistics().referenceCount);
  expectValid(tree);
}

TEST(DepthLimit, OfOneMakesASingleLeaf) {
  MeshGenerator generator(kSeed);
  BuildOptions options;
  options.depthLimit = 1;
  const auto tree = buildTree(generator.soupOfAnyCoordinates<float>(500, 0.1f), options);
  ASSERT_TRUE(tree.root().isLeaf());
  EXPECT_EQ(tree.root().leaf().count(), 500u);
  EXPECT_EQ(tree.statistics().depth, 1u);
}

TEST(DepthLimit, IsKeptAndReached) {
  MeshGenerator generator(kSeed);
  const auto mesh = generator.soupOfAnyCoordinates<float>(1500, 0.1f);
  for (const std::uint32_t limit : {2u, 3u, 7u, 12u}) {
    BuildOptions options;
    options.depthLimit = limit;
    options.leafSize = 0;
    options.stopsByCost = false;
    const auto tree = buildTree(mesh.view(), options);
    EXPECT_EQ(tree.statistics().depth, limit);
    expectValid(tree);
  }
}

TEST(DepthLimit, GrowsWithTheLogarithmOfTheObjectsIfUnset) {
  MeshGenerator generator(kSeed);
  for (const int count : {1, 2, 16, 256}) {
    BuildOptions options;
    options.leafSize = 0;
    options.stopsByCost = false;
    const auto tree = buildTree(generator.integerSoup<float>(count, 100, 40), options);
    const double levels = 8.0 + 1.3 * std::log2(static_cast<double>(count));
    const auto limit = static_cast<std::uint32_t>(std::lround(levels));
    EXPECT_LE(tree.statistics().depth, limit) << count;
    if (count >= 16) {
      EXPECT_EQ(tree.statistics().depth, limit) << count;
    }
  }
}

TEST(DepthLimit, MayBeTheGreatestDepth) {
  // Each face is half as large as the last, all in one corner: every level can cut one off.
  TriangleMesh<float> mesh;
  for (int i = 0; i < 100; ++i) {
    const float size = std::ldexp(1.0f, -i);
    test::addFace<float>(mesh, {{{size, 0, 0}, {0, size, 0}, {0, 0, size}}});
  }
  BuildOptions options;
  options.depthLimit = kMaxTreeDepth;
  options.leafSize = 0;
  options.cost = {.traversalCost = 0.0, .intersectionCost = 1.0, .emptyBonus = 0.0};
  options.referencesPerObject = 0;
  const auto tree = buildTree(mesh, options);
  EXPECT_EQ(tree.statistics().depth, kMaxTreeDepth);
  expectValid(tree);
}

TEST(ReferencesPerObject, BoundsTheReferencesOfFacesThatMeetInOneCorner) {
  // A polygon cut into a fan: all long thin faces share its first corner.
  TriangleMesh<float> mesh;
  std::vector<std::uint32_t> corners;
  constexpr std::uint32_t kCornerCount = 800;
  for (std::uint32_t i = 0; i < kCornerCount; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(kCornerCount);
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0.3f * std::cos(angle)});
    corners.push_back(i);
  }
  mesh.addPolygon(corners, 0);
  for (const std::uint32_t bound : {1u, 2u, 32u}) {
    BuildOptions options;
    options.cost.faceCost = 1.0;
    options.referencesPerObject = bound;
    const auto tree = buildTree(mesh.view(), options);
    EXPECT_LE(tree.statistics().referenceCount, std::uint64_t{bound} * mesh.faces.size());
    expectValid(tree);
  }
  BuildOptions unbounded;
  unbounded.cost.faceCost = 1.0;
  unbounded.referencesPerObject = 0;
  EXPECT_GT(buildTree(mesh.view(), unbounded).statistics().referenceCount, 32 * mesh.faces.size());
}

TEST(LeafSize, EndsCellsThatHoldAsManyOrFewer) {
  MeshGenerator generator(kSeed);
  const auto mesh = generator.soupOfAnyCoordinates<float>(300, 0.05f);
  BuildOptions options;
  options.leafSize = 300;
  EXPECT_EQ(buildTree(mesh.view(), options).nodes().size(), 1u);
  options.leafSize = 299;
  EXPECT_GT(buildTree(mesh.view(), options).nodes().size(), 1u);
  options.leafSize = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(buildTree(mesh.view(), options).nodes().size(), 1u);
}

TEST(LeafSize, BoundsLeavesWhereNothingElseStops) {
  MeshGenerator generator(kSeed);
  const auto mesh = generator.soupOfAnyCoordinates<float>(300, 0.01f);
  for (const std::uint32_t leafSize : {3u, 8u, 20u}) {
    BuildOptions options;
    options.leafSize = leafSize;
    options.stopsByCost = false;
    options.depthLimit = 40;
    EXPECT_LE(buildTree(mesh.view(), options).statistics().largestLeaf, leafSize);
  }
}

TEST(LeafSize, OfZeroStillEndsAtEmptyCells) {
  MeshGenerator generator(kSeed);
  BuildOptions options;
  options.leafSize = 0;
  options.stopsByCost = false;
  options.depthLimit = 12;
  const auto tree = buildTree(generator.axisAlignedGrid<float>(50, 4), options);
  EXPECT_GT(tree.statistics().emptyLeafCount, 0u);
  expectValid(tree);
}

TEST(StopsByCost, MakesALeafWhereSplittingIsTooDear) {
  MeshGenerator generator(kSeed);
  const auto mesh = generator.soupOfAnyCoordinates<float>(300, 0.05f);
  BuildOptions options;
  options.cost.traversalCost = 1e6;
  EXPECT_EQ(buildTree(mesh.view(), options).nodes().size(), 1u);
  options.stopsByCost = false;
  EXPECT_GT(buildTree(mesh.view(), options).nodes().size(), 1u);
}

TEST(StopsByCost, NeverSplitsAtTheCostOfTheLeafOrMore) {
  // One sheet in the middle of a box: both halves are met with chance 3/4 or less, but the split
  // costs 0.75 * 8 of 8 objects plus the traversal.
  TriangleMesh<float> mesh;
  for (int i = 0; i < 4; ++i) {
    test::addFace<float>(mesh, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}});
    test::addFace<float>(mesh, {{{1, 0, 0}, {2, 0, 0}, {2, 1, 1}}});
  }
  BuildOptions options;
  options.leafSize = 0;
  options.depthLimit = 2;
  // Areas: cell 2 (2 + 1 + 2), halves 2 (1 + 1 + 1); 4 objects on each side.
  const double splitCost = 8.0 * (6.0 / 10.0);
  options.cost = {.traversalCost = 8.0 - splitCost + 1e-9, .faceCost = 1.0};
  EXPECT_TRUE(buildTree(mesh.view(), options).root().isLeaf());
  options.cost.traversalCost = 8.0 - splitCost - 1e-9;
  EXPECT_FALSE(buildTree(mesh.view(), options).root().isLeaf());
}

TEST(StopsByCost, LowersTheExpectedCost) {
  MeshGenerator generator(kSeed);
  const auto mesh = generator.soupOfAnyCoordinates<float>(500, 0.1f);
  const auto tree = buildTree(mesh.view());
  EXPECT_LT(tree.statistics().sahCost, 500.0 * tree.options().cost.faceCost);
}

TEST(AllowsEmptyCells, CutsOffEmptySpace) {
  MeshGenerator generator(kSeed);
  const auto mesh = generator.soupOfAnyCoordinates<float>(200, 0.05f);
  BuildOptions options;
  options.cost.faceCost = 1.0;
  EXPECT_GT(buildTree(mesh.view(), options).statistics().emptyLeafCount, 0u);
}

TEST(AllowsEmptyCells, LeavesNoEmptyCellWhenOff) {
  for (std::uint32_t seed = kSeed; seed < kSeed + 20; ++seed) {
    MeshGenerator generator(seed);
    for (const bool clips : {false, true}) {
      BuildOptions options;
      options.allowsEmptyCells = false;
      options.clipsReferences = clips;
      options.stopsByCost = false;
      options.leafSize = 1;
      options.depthLimit = 12;
      const auto tree = buildTree(generator.soupOfAnyCoordinates<float>(60, 0.3f), options);
      EXPECT_EQ(tree.statistics().emptyLeafCount, 0u) << "seed " << seed << ", clips " << clips;
    }
  }
}

TEST(ClipsReferences, RemovesFalseEntries) {
  MeshGenerator generator(kSeed);
  const auto mesh = generator.slivers<float>(300, 100);
  BuildOptions options;
  options.cost.faceCost = 1.0;
  const auto clipped = buildTree(mesh.view(), options).statistics();
  options.clipsReferences = false;
  const auto whole = buildTree(mesh.view(), options).statistics();
  EXPECT_LT(clipped.sahCost, whole.sahCost);
}

struct BadOption {
  const char* name;  ///< as the message must give it
  BuildOptions options;
};

std::vector<BadOption> badOptions() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  std::vector<BadOption> bad;
  for (const std::uint32_t limit : {0u, kMaxTreeDepth + 1, 0xFFFF'FFFFu}) {
    bad.push_back({"depthLimit", {}});
    bad.back().options.depthLimit = limit;
  }
  for (const double cost : {-1.0, -0x1p-1074, kInfinity, -kInfinity, kNaN}) {
    bad.push_back({"traversalCost", {}});
    bad.back().options.cost.traversalCost = cost;
    bad.push_back({"intersectionCost", {}});
    bad.back().options.cost.intersectionCost = cost;
    bad.push_back({"faceCost", {}});
    bad.back().options.cost.faceCost = cost;
  }
  for (const double bonus : {1.0, 1.5, -0.1, kInfinity, -kInfinity, kNaN}) {
    bad.push_back({"emptyBonus", {}});
    bad.back().options.cost.emptyBonus = bonus;
  }
  return bad;
}

TEST(InvalidOptions, AreRefusedWithTheirNameAndAdvice) {
  for (const BadOption& bad : badOptions()) {
    try {
      static_cast<void>(buildTree(copiesOfOneFace(3), bad.options));
      FAIL() << bad.name << " was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::InvalidOption);
      EXPECT_NE(std::string(error.what()).find(bad.name), std::string::npos) << error.what();
      EXPECT_EQ(error.advice().substr(0, 5), "Give ") << error.advice();
      EXPECT_NE(std::string(error.what()).find(error.advice()), std::string::npos);
    }
  }
}

TEST(InvalidOptions, AreRefusedForEmptyInputToo) {
  BuildOptions options;
  options.depthLimit = 0;
  EXPECT_THROW(static_cast<void>(buildTree(TriangleMesh<float>{}, options)), Error);
}

TEST(BuildOptions, TakesTheEndsOfAllRanges) {
  BuildOptions options;
  options.depthLimit = kMaxTreeDepth;
  options.leafSize = 0;
  options.cost = {
      .traversalCost = 0.0, .intersectionCost = 0.0, .faceCost = 0.0, .emptyBonus = 0.0};
  MeshGenerator generator(kSeed);
  const auto mesh = generator.soupOfAnyCoordinates<float>(30, 0.1f);
  EXPECT_EQ(buildTree(mesh.view(), options).nodes().size(), 1u);
  options.cost = {.traversalCost = std::numeric_limits<double>::max(),
                  .intersectionCost = std::numeric_limits<double>::max(),
                  .faceCost = std::numeric_limits<double>::max(),
                  .emptyBonus = std::nextafter(1.0, 0.0)};
  expectValid(buildTree(mesh.view(), options));
}

}  // namespace
}  // namespace planetree
