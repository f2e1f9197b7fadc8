#include <planetree/build_tree.hpp>
#include <planetree/node/validate_tree.hpp>

#include "unit/split/exact_overlap.hpp"
#include "unit/split/random_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace planetree {
namespace {

using test::Contact;
using test::MeshGenerator;
using test::OverlapJudge;

constexpr std::uint32_t kSeed = 161'803;

struct LeafCell {
  LeafNode leaf;
  Box3 cell;
};

void collectLeaves(const Node& node, const Box3& cell, std::vector<LeafCell>& leaves) {
  if (node.isLeaf()) {
    leaves.push_back({node.leaf(), cell});
    return;
  }
  const SplitNode& split = node.split();
  Box3 left = cell;
  Box3 right = cell;
  left.upper[split.axis()] = split.position();
  right.lower[split.axis()] = split.position();
  collectLeaves(split.left(), left, leaves);
  collectLeaves(split.right(), right, leaves);
}

template <class T>
std::vector<LeafCell> leavesOf(const KdTree<Face<T>>& tree) {
  std::vector<LeafCell> leaves;
  collectLeaves(tree.root(), tree.bounds(), leaves);
  return leaves;
}

template <class T>
bool lists(const KdTree<Face<T>>& tree, const LeafNode& leaf, std::uint32_t face) {
  const auto references = tree.references(leaf);
  return std::binary_search(references.begin(), references.end(), face);
}

template <class T>
bool isSkipped(const TriangleMesh<T>& mesh, std::uint32_t face) {
  const auto [a, b, c] = mesh.view().corners(face);
  return a == b || b == c || c == a;
}

bool hasInterior(const Box3& box) {
  return box.lower.x < box.upper.x && box.lower.y < box.upper.y && box.lower.z < box.upper.z;
}

/// Whether all corners lie on the far side of one wall of the cell: a quick answer for most pairs.
template <class T>
bool isBeside(const std::array<Vec3<T>, 3>& corners, const Box3& cell) {
  const auto areAll = [&](const auto& condition) {
    return std::all_of(corners.begin(), corners.end(), condition);
  };
  return std::any_of(kAxes.begin(), kAxes.end(), [&](Axis axis) {
    return areAll([&](const Vec3<T>& corner) { return corner[axis] < T{cell.lower[axis]}; }) ||
           areAll([&](const Vec3<T>& corner) { return corner[axis] > T{cell.upper[axis]}; });
  });
}

/// Entries of leaves, and how many of them name a face that does not touch the closed cell.
struct EntryCounts {
  std::uint64_t all = 0;
  std::uint64_t falseOnes = 0;
};

/// Every face that touches the interior of a leaf's cell is listed there, and every face listed
/// there touches the cell grown by `margin`.
template <int kCornerBits, int kWallBits, class T>
void expectExactLists(const TriangleMesh<T>& mesh, const KdTree<Face<T>>& tree, double margin,
                      EntryCounts& counts) {
  const std::vector<LeafCell> leaves = leavesOf(tree);
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    if (isSkipped(mesh, face))
      continue;
    const OverlapJudge<kCornerBits, kWallBits> judge(mesh.view().corners(face));
    for (const auto& [leaf, cell] : leaves) {
      if (!hasInterior(cell))
        continue;
      const bool isListed = lists(tree, leaf, face);
      if (!isListed && isBeside(mesh.view().corners(face), cell))
        continue;
      if (judge.touches(cell, Contact::Interior)) {
        ASSERT_TRUE(isListed) << "face " << face;
      }
      if (!isListed)
        continue;
      ++counts.all;
      if (judge.touches(cell, Contact::Closed))
        continue;
      ++counts.falseOnes;
      ASSERT_TRUE(judge.touches(cell, Contact::Closed, margin)) << "face " << face;
    }
  }
}

/// Whether some leaf below the node whose closed cell holds the point lists the face.
template <class T>
bool isCovered(const KdTree<Face<T>>& tree, const Node& node, const Vec3d& point,
               std::uint32_t face) {
  if (node.isLeaf())
    return lists(tree, node.leaf(), face);
  const SplitNode& split = node.split();
  const double height = point[split.axis()] - static_cast<double>(split.position());
  return (height <= 0.0 && isCovered(tree, split.left(), point, face)) ||
         (height >= 0.0 && isCovered(tree, split.right(), point, face));
}

/// Points of each face, with corners and edges among them, are in a cell that lists the face. The
/// weights are eighths, so that few bits make the points exact.
template <class T>
void expectCovered(const TriangleMesh<T>& mesh, const KdTree<Face<T>>& tree) {
  constexpr int kParts = 8;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    if (isSkipped(mesh, face))
      continue;
    const auto [a, b, c] = mesh.view().corners(face);
    for (int i = 0; i <= kParts; ++i) {
      for (int j = 0; i + j <= kParts; ++j) {
        const Vec3d point = (static_cast<Vec3d>(a) * static_cast<double>(kParts - i - j) +
                             static_cast<Vec3d>(b) * static_cast<double>(i) +
                             static_cast<Vec3d>(c) * static_cast<double>(j)) /
                            static_cast<double>(kParts);
        ASSERT_TRUE(isCovered(tree, tree.root(), point, face))
            << "face " << face << " at (" << point.x << ", " << point.y << ", " << point.z << ")";
      }
    }
  }
}

struct NamedOptions {
  const char* name;
  BuildOptions options;
};

/// The clipped trees of the defaults and deeper ones, and trees of whole boxes.
std::vector<NamedOptions> clippingOptions() {
  BuildOptions deep;
  deep.leafSize = 1;
  deep.stopsByCost = false;
  deep.depthLimit = 11;
  BuildOptions normals = deep;
  normals.planarRule = PlanarRule::NormalSign;
  BuildOptions withoutEmptyCells = deep;
  withoutEmptyCells.allowsEmptyCells = false;
  BuildOptions retracted = BuildOptions::high();
  retracted.cost.faceCost = 1.0;
  return {{"defaults", {}},
          {"deep", deep},
          {"deep with normals", normals},
          {"deep without empty cells", withoutEmptyCells},
          {"retracted", retracted}};
}

std::vector<NamedOptions> boxOptions() {
  BuildOptions whole;
  whole.clipsReferences = false;
  BuildOptions deep = whole;
  deep.leafSize = 1;
  deep.stopsByCost = false;
  deep.depthLimit = 9;
  BuildOptions fast = BuildOptions::fast();
  fast.cost.faceCost = 1.0;
  return {{"textbook", BuildOptions::textbook()},
          {"whole boxes", whole},
          {"deep boxes", deep},
          {"fast", fast}};
}

/// How far a cell is grown before faces are clipped to it, at most (clip_triangle.cpp).
double clippingMargin(double largestCoordinate) {
  return largestCoordinate * 0x1p-44;
}

constexpr double kExtent = 64.0;

/// Judges the trees of meshes with integer coordinates within `kExtent` of each other.
void expectCompleteTrees(const char* name,
                         const std::function<TriangleMesh<float>(MeshGenerator&)>& makeMesh,
                         double largestCoordinate = kExtent) {
  constexpr int kRounds = 4;
  EntryCounts clipped;
  EntryCounts boxes;
  for (std::uint32_t seed = kSeed; seed < kSeed + kRounds; ++seed) {
    MeshGenerator generator(seed);
    const TriangleMesh<float> mesh = makeMesh(generator);
    const auto judgeTree = [&](const NamedOptions& named, double margin, EntryCounts& counts) {
      SCOPED_TRACE(testing::Message() << name << ", seed " << seed << ", " << named.name);
      const auto tree = buildTree(mesh.view(), named.options);
      expectExactLists<0, 84>(mesh, tree, margin, counts);
      expectCovered(mesh, tree);
      EXPECT_FALSE(
          validateTree(tree.nodes(), tree.view().references, tree.bounds(), tree.objectCount()));
    };
    for (const NamedOptions& named : clippingOptions())
      judgeTree(named, clippingMargin(largestCoordinate), clipped);
    for (const NamedOptions& named : boxOptions())
      judgeTree(named, kExtent, boxes);
    if (testing::Test::HasFailure())
      return;
  }
  testing::Test::RecordProperty("ClippedEntries", std::to_string(clipped.all));
  testing::Test::RecordProperty("ClippedFalseEntries", std::to_string(clipped.falseOnes));
  testing::Test::RecordProperty("BoxEntries", std::to_string(boxes.all));
  testing::Test::RecordProperty("BoxFalseEntries", std::to_string(boxes.falseOnes));
  // Only what touches the cell within the margin is left, and that is rare.
  EXPECT_LE(clipped.falseOnes * 100, clipped.all);
}

TEST(Completeness, HoldsForIntegerSoups) {
  expectCompleteTrees(
      "soup", [](MeshGenerator& generator) { return generator.integerSoup<float>(120, 64, 16); });
}

TEST(Completeness, HoldsForSmallFacesOnACoarseGrid) {
  expectCompleteTrees("coarse soup", [](MeshGenerator& generator) {
    return generator.integerSoup<float>(150, 6, 2);
  });
}

TEST(Completeness, HoldsForSlivers) {
  expectCompleteTrees("slivers",
                      [](MeshGenerator& generator) { return generator.slivers<float>(60, 64); });
}

TEST(Completeness, HoldsForAxisAlignedGrids) {
  expectCompleteTrees(
      "grid", [](MeshGenerator& generator) { return generator.axisAlignedGrid<float>(100, 5); });
}

TEST(Completeness, HoldsForFansAroundOneCorner) {
  expectCompleteTrees("fan", [](MeshGenerator& generator) { return generator.fan<float>(60, 64); });
}

TEST(Completeness, HoldsForCoplanarFaces) {
  for (const Axis across : kAxes) {
    expectCompleteTrees(axisName(across), [across](MeshGenerator& generator) {
      return generator.coplanarSoup<float>(80, 60, across, 7);
    });
  }
}

TEST(Completeness, HoldsForCoplanarFacesAmidOthers) {
  expectCompleteTrees("sheet in a soup", [](MeshGenerator& generator) {
    TriangleMesh<float> mesh = generator.coplanarSoup<float>(60, 60, Axis::Y, 20);
    const TriangleMesh<float> soup = generator.integerSoup<float>(60, 60, 20);
    for (std::uint32_t face = 0; face < soup.faces.size(); ++face)
      test::addFace(mesh, soup.view().corners(face));
    return mesh;
  });
}

// Boxes of clipped faces are rounded to whole eighths here.
TEST(Completeness, HoldsFarFromTheOrigin) {
  constexpr float kFar = 0x1p20f;
  const auto farAway = [](TriangleMesh<float> mesh) {
    for (Vec3f& position : mesh.positions)
      position = position + Vec3f{kFar, -kFar, kFar};
    return mesh;
  };
  const double largest = double{kFar} + kExtent;
  expectCompleteTrees(
      "far soup",
      [&](MeshGenerator& generator) { return farAway(generator.integerSoup<float>(100, 63, 16)); },
      largest);
  expectCompleteTrees(
      "far slivers",
      [&](MeshGenerator& generator) { return farAway(generator.slivers<float>(60, 63)); }, largest);
}

// Large enough for the builder to make the two sides of several splits apart from each other.
TEST(Completeness, HoldsForLargeMeshes) {
  MeshGenerator generator(kSeed);
  for (NamedOptions named : {clippingOptions().front(), boxOptions()[1]}) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", " << named.name);
    const TriangleMesh<float> mesh = generator.integerSoup<float>(20'000, 64, 2);
    expectCovered(mesh, buildTree(mesh.view(), named.options));
    // Few leaves, so that each can be judged with each face.
    named.options.leafSize = 1000;
    const auto tree = buildTree(mesh.view(), named.options);
    EXPECT_FALSE(
        validateTree(tree.nodes(), tree.view().references, tree.bounds(), tree.objectCount()));
    EXPECT_GT(tree.statistics().leafNodeCount, 20u);
    EntryCounts counts;
    expectExactLists<0, 84>(mesh, tree, kExtent, counts);
  }
}

// Corners in double have more bits than boxes in float hold: they must be rounded outward.
TEST(Completeness, HoldsForCornersThatFloatCannotHold) {
  constexpr int kCornerBits = 24;
  EntryCounts counts;
  for (std::uint32_t seed = kSeed; seed < kSeed + 4; ++seed) {
    MeshGenerator generator(seed);
    // Twenty-seven bits, of which float holds the first twenty-four.
    TriangleMesh<double> mesh = generator.integerSoup<double>(100, (1 << 27) - 1, 1 << 25);
    for (Vec3d& position : mesh.positions)
      position = position * std::ldexp(1.0, -kCornerBits);
    for (const NamedOptions& named : clippingOptions()) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << named.name);
      const auto tree = buildTree(mesh.view(), named.options);
      // The largest coordinate is below 8; the margin far below one ulp of float.
      expectExactLists<kCornerBits, 64>(mesh, tree, 0x1p-41, counts);
      expectCovered(mesh, tree);
    }
    if (HasFailure())
      return;
  }
  RecordProperty("Entries", std::to_string(counts.all));
  RecordProperty("FalseEntries", std::to_string(counts.falseOnes));
}

}  // namespace
}  // namespace planetree
