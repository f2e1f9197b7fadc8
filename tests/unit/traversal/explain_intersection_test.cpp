#include <planetree/traversal/explain_intersection.hpp>

#include <planetree/build_tree.hpp>
#include <planetree/shape/shapes.hpp>

#include "support/hard_cases.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace planetree::test {
namespace {

template <class T>
bool isInside(const Interval<T>& inner, const Interval<T>& outer) {
  return inner.tMin >= outer.tMin && inner.tMax <= outer.tMax;
}

/// Follows a walk through the tree's own nodes, and complains where a step does not fit the last.
template <class T>
class WalkCheck {
 public:
  WalkCheck(std::span<const Node> nodes, const Walk<T>& walk) : nodes_(nodes), walk_(walk) {
    if (walk.insideBounds)
      waiting_.push_back({0, 1, *walk.insideBounds});
  }

  void run() {
    for (const WalkStep<T>& step : walk_.steps) {
      std::visit([this](const auto& each) { this->check(each); }, step);
      if (testing::Test::HasFatalFailure())
        return;
    }
    EXPECT_TRUE(waiting_.empty()) << "cells that the walk forgot";
    EXPECT_EQ(counts_.splitNodes, walk_.counts.splitNodes);
    EXPECT_EQ(counts_.leafNodes, walk_.counts.leafNodes);
    EXPECT_EQ(counts_.objects, walk_.counts.objects);
    EXPECT_EQ(walk_.hit, best_);
  }

 private:
  void check(const SplitStep<T>& step) {
    take(step.visit);
    ++counts_.splitNodes;
    const Node& node = nodes_[step.visit.node];
    ASSERT_FALSE(node.isLeaf());
    const SplitNode& split = node.split();
    EXPECT_EQ(step.axis, split.axis());
    EXPECT_EQ(step.position, split.position());
    ASSERT_TRUE(step.nearPart || step.farPart) << "a way on";
    const std::uint32_t left = step.visit.node + 1;
    const std::uint32_t right = step.visit.node + split.rightOffset();
    // The near child comes next, so it lies on top.
    if (step.farPart)
      await(step, step.leftIsNear ? right : left, *step.farPart);
    if (step.nearPart)
      await(step, step.leftIsNear ? left : right, *step.nearPart);
  }

  void check(const LeafStep<T>& step) {
    take(step.visit);
    ++counts_.leafNodes;
    counts_.objects += step.tests.size();
    const Node& node = nodes_[step.visit.node];
    ASSERT_TRUE(node.isLeaf());
    EXPECT_EQ(step.objectCount, node.leaf().count());
    EXPECT_LE(step.tests.size(), step.objectCount);
    for (const ObjectTest<T>& test : step.tests) {
      if (test.hit) {
        EXPECT_EQ(test.hit->primitive, test.primitive);
        EXPECT_EQ(test.hit->geometry, test.geometry);
      }
      EXPECT_EQ(test.isAccepted, test.hit && (!best_ || isBefore(*test.hit, *best_)));
      if (test.isAccepted)
        best_ = test.hit;
    }
  }

  void check(const LeftOutStep<T>& step) {
    take(step.visit);
    EXPECT_TRUE(best_) << "nothing is left out before something is hit";
  }

  void take(const NodeVisit<T>& visit) {
    ASSERT_FALSE(waiting_.empty());
    const NodeVisit<T> expected = waiting_.back();
    waiting_.pop_back();
    EXPECT_EQ(visit.node, expected.node);
    EXPECT_EQ(visit.level, expected.level);
    EXPECT_EQ(visit.part.tMin, expected.part.tMin);
    EXPECT_EQ(visit.part.tMax, expected.part.tMax);
  }

  void await(const SplitStep<T>& step, std::uint32_t child, const Interval<T>& part) {
    EXPECT_TRUE(isInside(part, step.visit.part));
    waiting_.push_back({child, step.visit.level + 1, part});
  }

  std::span<const Node> nodes_;
  const Walk<T>& walk_;
  std::vector<NodeVisit<T>> waiting_;
  std::optional<Hit<T>> best_;
  StepCounts counts_;
};

template <class Tree, class T>
void expectToldAsItIs(const Tree& tree, const Ray<T>& ray, const QueryOptions& options = {}) {
  StepCounts counts;
  const auto hit = tree.findIntersection(ray, counts, options);
  const Walk<T> walk = tree.explainIntersection(ray, options);
  EXPECT_EQ(walk.hit, hit);
  EXPECT_EQ(walk.counts.splitNodes, counts.splitNodes);
  EXPECT_EQ(walk.counts.leafNodes, counts.leafNodes);
  EXPECT_EQ(walk.counts.objects, counts.objects);
  WalkCheck<T>(tree.nodes(), walk).run();

  StepCounts anyCounts;
  const bool isOccluded = tree.isOccluded(ray, anyCounts, options);
  const Walk<T> anyWalk = tree.explainOcclusion(ray, options);
  EXPECT_EQ(anyWalk.hit.has_value(), isOccluded);
  EXPECT_EQ(anyWalk.counts.splitNodes, anyCounts.splitNodes);
  EXPECT_EQ(anyWalk.counts.leafNodes, anyCounts.leafNodes);
  EXPECT_EQ(anyWalk.counts.objects, anyCounts.objects);
  WalkCheck<T>(tree.nodes(), anyWalk).run();
}

template <class T>
class ExplainIntersection : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ExplainIntersection, Scalars);

TYPED_TEST(ExplainIntersection, TellsWhatTheQueriesDoOnHardCases) {
  using T = TypeParam;
  BuildOptions deep;
  deep.leafSize = 1;
  deep.depthLimit = 24;
  deep.stopsByCost = false;
  std::uint64_t salt = 300;
  for (const HardMesh<T>& hard : hardMeshes<T>()) {
    for (const BuildOptions& options : {BuildOptions{}, BuildOptions::textbook(), deep}) {
      SCOPED_TRACE(hard.name + ", " + describeSeed());
      const auto tree = buildTree(hard.mesh.view(), options);
      for (const Ray<T>& ray : hardRays(hard.mesh, tree.bounds(), 60, ++salt)) {
        expectToldAsItIs(tree, ray);
        if (this->HasFailure())
          return;
      }
    }
  }
}

TYPED_TEST(ExplainIntersection, TellsNothingOfRaysThatMissByDefinition) {
  using T = TypeParam;
  const auto tree = buildTree(detail::soup<T>(3, 100, 0.3));
  for (const Ray<T>& ray : invalidRays<T>()) {
    const Walk<T> walk = tree.explainIntersection(ray);
    EXPECT_FALSE(walk.insideBounds);
    EXPECT_TRUE(walk.steps.empty());
    EXPECT_FALSE(walk.hit);
  }
}

TYPED_TEST(ExplainIntersection, TellsNothingOfRaysBesideTheBoundsAndOfEmptyTrees) {
  using T = TypeParam;
  const Ray<T> ray{.origin = {5, 5, 5}, .direction = {0, 0, 1}};
  EXPECT_FALSE(buildTree(detail::soup<T>(3, 100, 0.3)).explainIntersection(ray).insideBounds);
  EXPECT_FALSE(buildTree(TriangleMesh<T>{}).explainIntersection(ray).insideBounds);
  EXPECT_FALSE(KdTree<Face<T>>().explainOcclusion(ray).insideBounds);
}

TYPED_TEST(ExplainIntersection, TellsOfScenesWithMasks) {
  using T = TypeParam;
  Random random(11);
  std::vector<Sphere<T>> spheres;
  for (int i = 0; i < 50; ++i) {
    spheres.push_back(
        {random.pointIn<T>({-1, -1, -1}, {1, 1, 1}), static_cast<T>(random.between(0.1, 0.3))});
  }
  Scene<T> scene;
  scene.add(std::move(spheres), {.mask = 1});
  scene.add(detail::soup<T>(12, 100, 0.3), {.mask = 2});
  const auto tree = buildTree(scene);
  for (const Ray<T>& ray : hardRays(TriangleMesh<T>{}, tree.bounds(), 200, 13)) {
    SCOPED_TRACE(describeSeed());
    expectToldAsItIs(tree, ray);
    expectToldAsItIs(tree, ray, {.mask = 2});
    expectToldAsItIs(tree, ray, {.mask = 4});
  }
}

/// Two leaning walls across x, from 1 to 1.5 and from 3 to 3.5, with a split between them.
KdTree<Face<float>> twoWalls() {
  TriangleMesh<float> mesh;
  mesh.positions = {{1, -1, -1}, {1.5f, 1, -1}, {1.25f, 0, 1},
                    {3, -1, -1}, {3.5f, 1, -1}, {3.25f, 0, 1}};
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  BuildOptions options;
  options.leafSize = 1;
  options.stopsByCost = false;
  options.depthLimit = 2;
  return buildTree(std::move(mesh), options);
}

TEST(Walk, OfARayThroughTwoCellsIsTheOneExpected) {
  const auto tree = twoWalls();
  ASSERT_EQ(tree.nodes().size(), 3u);
  const float plane = tree.root().split().position();
  const Rayf ray{.origin = {0, 0, 0}, .direction = {1, 0, 0}};
  const Walk<float> walk = tree.explainIntersection(ray);
  ASSERT_TRUE(walk.insideBounds);
  EXPECT_NEAR(walk.insideBounds->tMin, 1.0f, 1e-4f);
  EXPECT_NEAR(walk.insideBounds->tMax, 3.5f, 1e-4f);
  ASSERT_EQ(walk.steps.size(), 3u);

  const auto& split = std::get<SplitStep<float>>(walk.steps[0]);
  EXPECT_EQ(split.visit.node, 0u);
  EXPECT_EQ(split.visit.level, 1u);
  EXPECT_EQ(split.axis, Axis::X);
  EXPECT_EQ(split.position, plane);
  EXPECT_TRUE(split.leftIsNear);
  ASSERT_TRUE(split.nearPart && split.farPart);
  EXPECT_NEAR(split.nearPart->tMax, plane, 1e-4f);
  EXPECT_NEAR(split.farPart->tMin, plane, 1e-4f);

  const auto& leaf = std::get<LeafStep<float>>(walk.steps[1]);
  EXPECT_EQ(leaf.visit.node, 1u);
  EXPECT_EQ(leaf.visit.level, 2u);
  ASSERT_EQ(leaf.tests.size(), 1u);
  EXPECT_EQ(leaf.tests[0].primitive, 0u);
  ASSERT_TRUE(leaf.tests[0].hit);
  EXPECT_EQ(leaf.tests[0].hit->t, 1.25f);
  EXPECT_TRUE(leaf.tests[0].isAccepted);

  // The split is at 1.5 or 3: either way the far cell begins beyond the hit.
  const auto& leftOut = std::get<LeftOutStep<float>>(walk.steps[2]);
  EXPECT_EQ(leftOut.visit.node, 2u);
  EXPECT_EQ(leftOut.visit.part.tMin, split.farPart->tMin);
  ASSERT_TRUE(walk.hit);
  EXPECT_EQ(walk.hit->primitive, 0u);
}

TEST(Walk, FromAboveMeetsTheRightChildFirst) {
  const auto tree = twoWalls();
  const Rayf ray{.origin = {4, 0, 0}, .direction = {-1, 0, 0}};
  const Walk<float> walk = tree.explainIntersection(ray);
  EXPECT_FALSE(std::get<SplitStep<float>>(walk.steps.at(0)).leftIsNear);
  ASSERT_TRUE(walk.hit);
  EXPECT_EQ(walk.hit->primitive, 1u);
}

TEST(Walk, AlongASplitPlaneVisitsBothSidesOverTheWholeInterval) {
  const auto tree = twoWalls();
  const Rayf ray{.origin = {tree.root().split().position(), 0, -5}, .direction = {0, 0, 1}};
  const Walk<float> walk = tree.explainIntersection(ray);
  const auto& split = std::get<SplitStep<float>>(walk.steps.at(0));
  ASSERT_TRUE(split.nearPart && split.farPart);
  EXPECT_EQ(split.nearPart->tMin, split.visit.part.tMin);
  EXPECT_EQ(split.nearPart->tMax, split.visit.part.tMax);
  EXPECT_EQ(split.farPart->tMin, split.visit.part.tMin);
  EXPECT_EQ(split.farPart->tMax, split.visit.part.tMax);
}

TEST(Walk, TellsOfAHitOutsideTheCellItWasFoundIn) {
  // One long triangle through many cells, hit in the last of them but tested in the first.
  TriangleMesh<float> mesh = detail::soup<float>(5, 60, 0.2f);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{-2, -2, -2}, {2, -2, 2}, {0, 2, 0}});
  mesh.faces.push_back({first, first + 1, first + 2});
  const auto tree = buildTree(std::move(mesh), {.leafSize = 4, .cost = {.faceCost = 1.0}});
  Random random(6);
  std::size_t outsideCount = 0;
  for (int i = 0; i < 500; ++i) {
    const Rayf ray{.origin = random.pointIn<float>({-3, -3, -3}, {3, 3, 3}),
                   .direction = random.pointIn<float>({-1, -1, -1}, {1, 1, 1})};
    for (const auto& step : tree.explainIntersection(ray).steps) {
      if (const auto* leaf = std::get_if<LeafStep<float>>(&step)) {
        outsideCount += static_cast<std::size_t>(std::count_if(
            leaf->tests.begin(), leaf->tests.end(),
            [&](const auto& test) { return test.hit && test.hit->t > leaf->visit.part.tMax; }));
      }
    }
  }
  EXPECT_GT(outsideCount, 0u) << describeSeed();
}

TEST(Walk, OfAnyHitLeavesOutAllThatWaited) {
  const auto tree = buildTree(detail::soup<float>(14, 500, 0.2f));
  std::size_t leftOutCount = 0;
  for (const Rayf& ray : hardRays(TriangleMesh<float>{}, tree.bounds(), 200, 15)) {
    const Walk<float> walk = tree.explainOcclusion(ray);
    WalkCheck<float>(tree.nodes(), walk).run();
    for (const auto& step : walk.steps) {
      if (std::holds_alternative<LeftOutStep<float>>(step))
        ++leftOutCount;
    }
  }
  EXPECT_GT(leftOutCount, 0u) << describeSeed();
}

}  // namespace
}  // namespace planetree::test
