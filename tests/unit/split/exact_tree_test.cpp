#include <planetree/build_tree.hpp>
#include <planetree/mesh/clip_triangle.hpp>

#include "support/textbook_oracle.hpp"
#include "unit/split/random_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace planetree {
namespace {

using test::MeshGenerator;

constexpr std::uint32_t kSeed = 57'721;

/// The rules of the library, written down slowly: all planes are counted by looking at all
/// references again, and each cell has lists of its own. It shares no code with the builder but the
/// types, the costs, and the clipping of a triangle.
class SlowBuilder {
 public:
  SlowBuilder(const TriangleMesh<float>& mesh, const BuildOptions& options,
              std::uint32_t depthLimit)
      : mesh_(mesh), options_(options), depthLimit_(depthLimit) {
    options_.cost.intersectionCost = options_.cost.faceCost;
  }

  /// Compares the tree of these references with what the builder made.
  template <class O>
  void expectSame(const KdTree<O>& tree, const Node& node, const std::vector<Reference>& references,
                  const Box3& cell, std::uint32_t level) const {
    const auto plane = planeFor(references, cell, level);
    ASSERT_EQ(node.isLeaf(), !plane.has_value()) << "level " << level;
    if (node.isLeaf()) {
      std::vector<std::uint32_t> wanted;
      for (const Reference& reference : references)
        wanted.push_back(reference.object);
      const auto objects = tree.references(node.leaf());
      EXPECT_EQ(std::vector(objects.begin(), objects.end()), wanted);
      return;
    }
    EXPECT_EQ(node.split().axis(), plane->axis);
    EXPECT_EQ(node.split().position(), plane->position);
    if (testing::Test::HasFailure())
      return;
    const Box3 left = test::leftBoxOf(cell, plane->axis, plane->position);
    const Box3 right = test::rightBoxOf(cell, plane->axis, plane->position);
    const auto [leftOnes, rightOnes] = divide(references, *plane, left, right);
    expectSame(tree, node.split().left(), leftOnes, left, level + 1);
    expectSame(tree, node.split().right(), rightOnes, right, level + 1);
  }

 private:
  [[nodiscard]] std::optional<test::OraclePlane> planeFor(const std::vector<Reference>& references,
                                                          const Box3& cell,
                                                          std::uint32_t level) const {
    if (references.size() <= options_.leafSize || level == depthLimit_)
      return std::nullopt;
    const auto best = test::findBestSplitPlaneByCounting(references, cell, options_);
    const bool pays =
        best && (!options_.stopsByCost || best->cost < options_.cost.leafCost(references.size()));
    const bool isAllowed =
        pays && (options_.allowsEmptyCells || (best->leftCount != 0 && best->rightCount != 0));
    return isAllowed ? best : std::nullopt;
  }

  [[nodiscard]] std::pair<std::vector<Reference>, std::vector<Reference>> divide(
      const std::vector<Reference>& references, const test::OraclePlane& plane, const Box3& left,
      const Box3& right) const {
    std::pair<std::vector<Reference>, std::vector<Reference>> sides;
    for (const Reference& reference : references) {
      const float lower = reference.bounds.lower[plane.axis];
      const float upper = reference.bounds.upper[plane.axis];
      const bool liesIn = lower == plane.position && upper == plane.position;
      const bool isLeft = liesIn ? plane.planarSide == Side::Left : lower < plane.position;
      const bool isRight = liesIn ? plane.planarSide == Side::Right : upper > plane.position;
      if (isLeft)
        add(sides.first, reference, left, isLeft && isRight);
      if (isRight)
        add(sides.second, reference, right, isLeft && isRight);
    }
    return sides;
  }

  void add(std::vector<Reference>& side, Reference reference, const Box3& cell,
           bool isOnBothSides) const {
    if (isOnBothSides && options_.clipsReferences) {
      const auto [a, b, c] = mesh_.view().corners(reference.object);
      reference.bounds =
          intersection(reference.bounds, intersection(clippedTriangleBounds(a, b, c, cell), cell));
      if (reference.bounds.isEmpty())
        return;
    }
    side.push_back(reference);
  }

  const TriangleMesh<float>& mesh_;
  BuildOptions options_;
  std::uint32_t depthLimit_;
};

void expectExactTree(const TriangleMesh<float>& mesh, const BuildOptions& options) {
  std::vector<Reference> references;
  Box3 bounds;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    const auto [a, b, c] = mesh.view().corners(face);
    if (a == b || b == c || c == a)
      continue;
    Reference reference;
    reference.object = face;
    for (const Vec3f& corner : {a, b, c})
      reference.bounds.extend(corner);
    bounds.extend(reference.bounds);
    references.push_back(reference);
  }
  const auto tree = buildTree(mesh.view(), options);
  SlowBuilder(mesh, options, options.depthLimit.value())
      .expectSame(tree, tree.root(), references, bounds, 1);
}

std::vector<std::pair<std::string, BuildOptions>> exactOptions() {
  BuildOptions clipped;
  clipped.leafSize = 2;
  clipped.depthLimit = 14;
  clipped.cost.faceCost = 1.0;
  clipped.referencesPerObject = 0;
  BuildOptions whole = clipped;
  whole.clipsReferences = false;
  BuildOptions full = clipped;
  full.stopsByCost = false;
  full.depthLimit = 7;
  BuildOptions blocks = clipped;
  blocks.cost.faceCost = 0.05;
  blocks.leafSize = 4;
  return {{"clipped", clipped}, {"whole boxes", whole}, {"to the limit", full}, {"blocks", blocks}};
}

template <class MakeMesh>
void expectExactTrees(const MakeMesh& makeMesh) {
  for (const auto& [name, options] : exactOptions()) {
    for (std::uint32_t seed = kSeed; seed < kSeed + 6; ++seed) {
      SCOPED_TRACE(testing::Message() << name << ", seed " << seed);
      MeshGenerator generator(seed);
      expectExactTree(makeMesh(generator), options);
      if (testing::Test::HasFailure())
        return;
    }
  }
}

TEST(ExactTree, IsThatOfTheSlowBuilderOnSoups) {
  expectExactTrees(
      [](MeshGenerator& generator) { return generator.soupOfAnyCoordinates<float>(250, 0.3f); });
}

TEST(ExactTree, IsThatOfTheSlowBuilderOnIntegerSoups) {
  expectExactTrees(
      [](MeshGenerator& generator) { return generator.integerSoup<float>(200, 6, 3); });
}

TEST(ExactTree, IsThatOfTheSlowBuilderOnSlivers) {
  expectExactTrees([](MeshGenerator& generator) { return generator.slivers<float>(150, 8); });
}

TEST(ExactTree, IsThatOfTheSlowBuilderOnAxisAlignedGrids) {
  expectExactTrees(
      [](MeshGenerator& generator) { return generator.axisAlignedGrid<float>(150, 6); });
}

TEST(ExactTree, IsThatOfTheSlowBuilderOnFans) {
  expectExactTrees([](MeshGenerator& generator) { return generator.fan<float>(120, 8); });
}

TEST(ExactTree, IsThatOfTheSlowBuilderOnCoplanarFaces) {
  expectExactTrees(
      [](MeshGenerator& generator) { return generator.coplanarSoup<float>(200, 8, Axis::Y, 3); });
}

}  // namespace
}  // namespace planetree
