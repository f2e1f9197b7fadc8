#include <planetree/build_tree.hpp>
#include <planetree/scene.hpp>

#include "unit/split/random_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

namespace planetree {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kLargest = std::numeric_limits<float>::max();

/// A shape that is its box, whatever that is.
struct BoxShape {
  using Scalar = float;
  Box3 box;

  [[nodiscard]] Box3 bounds() const { return box; }
  [[nodiscard]] std::optional<Hitf> intersect(const Rayf&, float, float) const noexcept {
    return std::nullopt;
  }
};

BoxShape cubeAt(float position) {
  return {.box = {.lower = {position, position, position},
                  .upper = {position + 1, position + 1, position + 1}}};
}

/// A shape of which one member throws.
struct ThrowingShape {
  using Scalar = float;
  Box3 box;
  bool throwsFromBounds = false;
  bool throwsFromClipping = false;

  [[nodiscard]] Box3 bounds() const {
    if (throwsFromBounds)
      throw std::domain_error("no bounds");
    return box;
  }
  [[nodiscard]] Box3 clippedBounds(const Box3& cell) const {
    if (throwsFromClipping)
      throw std::domain_error("no clipped bounds");
    return intersection(box, cell);
  }
  [[nodiscard]] std::optional<Hitf> intersect(const Rayf&, float, float) const noexcept {
    return std::nullopt;
  }
};

/// Enough overlapping shapes for several threads.
std::vector<ThrowingShape> overlappingShapes() {
  std::vector<ThrowingShape> shapes(20'000);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const float position = static_cast<float>(i) / 16.0f;
    shapes[i].box = {.lower = {position, 0, 0}, .upper = {position + 1, 1, 1}};
  }
  return shapes;
}

template <class O>
void expectEmptyTree(const KdTree<O>& tree) {
  ASSERT_EQ(tree.nodes().size(), 1u);
  ASSERT_TRUE(tree.root().isLeaf());
  EXPECT_EQ(tree.root().leaf().count(), 0u);
  EXPECT_TRUE(tree.view().references.empty());
  EXPECT_TRUE(tree.bounds().isEmpty());
}

/// The numbers of all objects that some leaf lists.
template <class O>
std::set<std::uint32_t> listedObjects(const KdTree<O>& tree) {
  const auto references = tree.view().references;
  return {references.begin(), references.end()};
}

template <class O>
std::vector<SkipReason> reasonsOf(const KdTree<O>& tree) {
  std::vector<SkipReason> reasons;
  for (const SkippedObject& skipped : tree.report().skipped)
    reasons.push_back(skipped.reason);
  return reasons;
}

TEST(BuildReport, CountsNothingForEmptyInput) {
  const auto mesh = buildTree(TriangleMesh<float>{});
  expectEmptyTree(mesh);
  EXPECT_EQ(mesh.report().objectCount, 0u);
  EXPECT_EQ(mesh.report().skippedCount, 0u);
  expectEmptyTree(buildTree(TriangleMeshView<double>{}));
  expectEmptyTree(buildTree(std::vector<BoxShape>{}));
  expectEmptyTree(buildTree(Scene<float>{}));
  expectEmptyTree(buildTree(TriangleMesh<float>{}, BuildOptions::textbook()));
}

TEST(BuildReport, CountsAllObjectsOfAnEmptyTreeIfAllAreBad) {
  TriangleMesh<float> mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, kNaN, 0}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}, {0, 0, 1}};
  const auto tree = buildTree(mesh);
  expectEmptyTree(tree);
  EXPECT_EQ(tree.report().objectCount, 3u);
  EXPECT_EQ(tree.report().skippedCount, 3u);
}

TEST(BuildReport, NamesEachReasonForFaces) {
  TriangleMesh<float> mesh;
  mesh.positions = {{0, 0, 0},         {1, 0, 0}, {0, 1, 0},    {kNaN, 0, 0},
                    {0, kInfinity, 0}, {0, 0, 0}, {-0.0f, 0, 0}};
  mesh.faces = {
      {0, 1, 2},             // good
      {0, 1, 7},             // one beyond the last vertex
      {0xFFFF'FFFFu, 1, 2},  // far beyond
      {0, 1, 3},             // NaN
      {4, 1, 2},             // infinite
      {0, 1, 1},             // the same index twice
      {0, 1, 5},             // the same point at two indices
      {0, 1, 6},             // the same point but for the sign of a zero
      {1, 2, 5},             // good
      {3, 3, 0xFFFF'FFFFu},  // several at once: the index comes first
      {3, 3, 3},             // NaN, repeated
  };
  const auto tree = buildTree(mesh);
  EXPECT_EQ(listedObjects(tree), (std::set<std::uint32_t>{0, 8}));
  using enum SkipReason;
  EXPECT_EQ(reasonsOf(tree),
            (std::vector{IndexOutOfRange, IndexOutOfRange, NotFinite, NotFinite, RepeatedCorner,
                         RepeatedCorner, RepeatedCorner, IndexOutOfRange, NotFinite}));
  const std::vector<std::uint32_t> faces = {1, 2, 3, 4, 5, 6, 7, 9, 10};
  for (std::size_t i = 0; i < faces.size(); ++i)
    EXPECT_EQ(tree.report().skipped[i].primitive, faces[i]);
  EXPECT_EQ(tree.report().objectCount, 11u);
  EXPECT_EQ(tree.report().skippedCount, 9u);
}

TEST(BuildReport, KeepsFacesWithCornersOnALine) {
  TriangleMesh<float> mesh;
  mesh.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  mesh.faces = {{0, 1, 2}};
  EXPECT_EQ(buildTree(mesh).report().skippedCount, 0u);
}

TEST(BuildReport, SkipsDoublesBeyondTheRangeOfFloat) {
  TriangleMesh<double> mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1e39, 0}, {0, -1e300, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const auto tree = buildTree(mesh);
  EXPECT_EQ(reasonsOf(tree), (std::vector{SkipReason::NotFinite, SkipReason::NotFinite}));
  EXPECT_EQ(listedObjects(tree), (std::set<std::uint32_t>{2}));
}

// A double just above the largest float rounds to it, but the box around it cannot.
TEST(BuildReport, SkipsDoublesThatNoFiniteBoxHolds) {
  TriangleMesh<double> mesh;
  const double beyond = static_cast<double>(kLargest) * (1.0 + 0x1p-40);
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, beyond, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}};
  const auto tree = buildTree(mesh);
  EXPECT_EQ(reasonsOf(tree), (std::vector{SkipReason::NotFinite}));
  EXPECT_TRUE(isFinite(tree.bounds().upper));
}

TEST(BuildReport, TakesTheWholeRangeOfFloat) {
  TriangleMesh<float> mesh;
  mesh.positions = {{kLargest, 0, 0}, {-kLargest, kLargest, 0}, {0, -kLargest, kLargest}};
  mesh.faces = {{0, 1, 2}};
  const auto tree = buildTree(mesh);
  EXPECT_EQ(tree.report().skippedCount, 0u);
  EXPECT_EQ(tree.root().leaf().count(), 1u);
}

TEST(BuildReport, NamesEachReasonForShapes) {
  const std::vector<BoxShape> shapes = {
      cubeAt(0),
      {.box = {}},
      {.box = {.lower = {0, 0, 0}, .upper = {1, kNaN, 1}}},
      {.box = {.lower = {0, -kInfinity, 0}, .upper = {1, 1, 1}}},
      {.box = {.lower = {2, 0, 0}, .upper = {1, 1, 1}}},
      cubeAt(5),
  };
  const auto tree = buildTree(shapes);
  using enum SkipReason;
  EXPECT_EQ(reasonsOf(tree), (std::vector{Empty, NotFinite, NotFinite, Empty}));
  EXPECT_EQ(listedObjects(tree), (std::set<std::uint32_t>{0, 5}));
}

TEST(BuildReport, SkipsNullPointers) {
  std::vector<std::unique_ptr<BoxShape>> shapes(5);
  shapes[1] = std::make_unique<BoxShape>(cubeAt(1));
  shapes[3] = std::make_unique<BoxShape>(cubeAt(3));
  const auto tree = buildTree(std::move(shapes));
  EXPECT_EQ(reasonsOf(tree), std::vector(3, SkipReason::Empty));
  EXPECT_EQ(listedObjects(tree), (std::set<std::uint32_t>{1, 3}));
  EXPECT_EQ(tree.report().objectCount, 5u);
}

TEST(BuildReport, SkipsNullPointersInVariantsAndOfRawKind) {
  const BoxShape cube = cubeAt(0);
  using Member = std::variant<BoxShape, const BoxShape*>;
  const std::vector<Member> members = {cube, nullptr, &cube};
  const auto tree = buildTree(members);
  EXPECT_EQ(reasonsOf(tree), (std::vector{SkipReason::Empty}));
  EXPECT_EQ(listedObjects(tree), (std::set<std::uint32_t>{0, 2}));
}

TEST(BuildReport, NumbersSkippedObjectsWithinTheirGeometry) {
  TriangleMesh<float> mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}, {0, 1, 9}};
  Scene<float> scene;
  scene.add(mesh);
  scene.add(std::vector<BoxShape>{{.box = {}}, cubeAt(0)});
  scene.add(mesh);
  const auto tree = buildTree(scene);
  const BuildReport& report = tree.report();
  EXPECT_EQ(report.objectCount, 6u);
  ASSERT_EQ(report.skippedCount, 3u);
  ASSERT_EQ(report.skipped.size(), 3u);
  const std::array<std::array<std::uint32_t, 2>, 3> expected = {{{0, 1}, {1, 0}, {2, 1}}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(report.skipped[i].geometry, expected[i][0]);
    EXPECT_EQ(report.skipped[i].primitive, expected[i][1]);
  }
  EXPECT_EQ(listedObjects(tree), (std::set<std::uint32_t>{0, 3, 4}));
}

TEST(BuildReport, CountsAllSkippedObjectsButListsOnlyTheFirstFew) {
  TriangleMesh<float> mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (std::uint32_t face = 0; face < 5000; ++face)
    mesh.faces.push_back({0, 1, face % 2 == 0 ? 2u : 3u});
  const auto tree = buildTree(mesh);
  const BuildReport& report = tree.report();
  EXPECT_EQ(report.objectCount, 5000u);
  EXPECT_EQ(report.skippedCount, 2500u);
  ASSERT_FALSE(report.skipped.empty());
  ASSERT_LE(report.skipped.size(), 100u);
  for (std::size_t i = 0; i < report.skipped.size(); ++i)
    EXPECT_EQ(report.skipped[i].primitive, 2 * i + 1);
  EXPECT_EQ(listedObjects(tree).size(), report.objectCount - report.skippedCount);
}

TEST(BuildReport, ListsEveryObjectThatIsNotSkipped) {
  constexpr std::uint32_t kSeed = 173'205;
  test::MeshGenerator generator(kSeed);
  for (const BuildOptions& options : {BuildOptions{}, BuildOptions::textbook()}) {
    const auto tree = buildTree(generator.integerSoup<float>(3000, 10, 2), options);
    EXPECT_GT(tree.report().skippedCount, 0u);
    EXPECT_EQ(listedObjects(tree).size() + tree.report().skippedCount, 3000u);
  }
}

TEST(BuildTree, PassesOnWhatShapesThrow) {
  for (const std::uint32_t threadCount : {1u, 4u}) {
    BuildOptions options;
    options.threadCount = threadCount;
    std::vector<ThrowingShape> shapes = overlappingShapes();
    EXPECT_NO_THROW(static_cast<void>(buildTree(shapes, options)));
    shapes[12'345].throwsFromBounds = true;
    EXPECT_THROW(static_cast<void>(buildTree(shapes, options)), std::domain_error);
    shapes[12'345].throwsFromBounds = false;
    for (ThrowingShape& shape : shapes)
      shape.throwsFromClipping = true;
    EXPECT_THROW(static_cast<void>(buildTree(shapes, options)), std::domain_error);
  }
}

TEST(BuildReport, HasPhasesThatAddUp) {
  test::MeshGenerator generator(1);
  const auto tree = buildTree(generator.soupOfAnyCoordinates<float>(2000, 0.1f));
  const BuildReport& report = tree.report();
  ASSERT_FALSE(report.phases.empty());
  EXPECT_EQ(report.phases.front().name, "bound");
  double sum = 0.0;
  for (const BuildPhase& phase : report.phases) {
    EXPECT_FALSE(phase.name.empty());
    EXPECT_GE(phase.seconds, 0.0);
    sum += phase.seconds;
  }
  EXPECT_NEAR(report.totalSeconds, sum, 1e-9);
}

}  // namespace
}  // namespace planetree
