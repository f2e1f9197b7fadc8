#include <planetree/build_tree.hpp>

#include "support/brute_force.hpp"
#include "support/hard_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>
#include <span>
#include <vector>

namespace {

// Counts allocations, to show that queries make none.
thread_local std::size_t allocationCount = 0;

}  // namespace

// Not inlined, or g++ takes the pair of malloc and free for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocationCount;
  if (void* memory = std::malloc(size > 0 ? size : 1))
    return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace planetree::test {
namespace {

template <class T>
class NodeIntersection : public testing::Test {
 protected:
  TriangleMesh<T> mesh_ = detail::soup<T>(51, 200, 0.3);
  // Face by face, so that there are splits to look at.
  KdTree<Face<T>> tree_ = buildTree(mesh_.view(), {.leafSize = 4, .cost = {.faceCost = 1.0}});
  std::vector<Ray<T>> rays_ = hardRays(mesh_, tree_.bounds(), 1000, 52);
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(NodeIntersection, Scalars);

/// Calls `visit` with every split of the tree.
template <class Visit>
void forEachSplit(std::span<const Node> nodes, Visit&& visit) {
  for (const Node& node : nodes) {
    if (!node.isLeaf())
      visit(node.split());
  }
}

TYPED_TEST(NodeIntersection, OfTheRootIsTheWholeQuery) {
  for (const auto& ray : this->rays_) {
    Hit<TypeParam> hit;
    const bool found =
        this->tree_.findIntersection(this->tree_.root(), ray, hit, ray.tMin, ray.tMax);
    EXPECT_EQ(found, this->tree_.findIntersection(ray).has_value());
    EXPECT_EQ(hit, this->tree_.findIntersection(ray).value_or(Hit<TypeParam>{}));
  }
}

TYPED_TEST(NodeIntersection, OfASplitIsThatOfItsChildrenTogether) {
  const auto view = this->tree_.view();
  std::size_t count = 0;
  forEachSplit(this->tree_.nodes(), [&](const SplitNode& split) {
    if (++count > 50)
      return;
    for (std::size_t i = 0; i < 50; ++i) {
      const auto& ray = this->rays_[i];
      Hit<TypeParam> whole;
      const bool found = findIntersection(split, view, ray, whole, ray.tMin, ray.tMax);
      Hit<TypeParam> parts;
      const bool near = findNearestIntersection(split, view, ray, parts, ray.tMin, ray.tMax);
      const bool far = findFartherIntersection(split, view, ray, parts, ray.tMin, ray.tMax);
      EXPECT_EQ(found, near || far);
      EXPECT_EQ(whole, parts);
    }
  });
}

TYPED_TEST(NodeIntersection, TreatsParallelRaysAsAnyOther) {
  const auto view = this->tree_.view();
  for (const auto& ray : this->rays_) {
    forEachSplit(this->tree_.nodes().first(std::min<std::size_t>(20, this->tree_.nodes().size())),
                 [&](const SplitNode& split) {
                   if (ray.direction[split.axis()] != TypeParam(0))
                     return;
                   Hit<TypeParam> parallel;
                   const bool found =
                       calculateAsNearParallel(split, view, ray, parallel, ray.tMin, ray.tMax);
                   Hit<TypeParam> hit;
                   findNearestIntersection(split, view, ray, hit, ray.tMin, ray.tMax);
                   findFartherIntersection(split, view, ray, hit, ray.tMin, ray.tMax);
                   EXPECT_EQ(parallel, hit);
                   EXPECT_EQ(found, hit.primitive != kNoId);
                 });
  }
}

TYPED_TEST(NodeIntersection, OfALeafTestsItsObjectsAndKeepsABetterHit) {
  const auto view = this->tree_.view();
  for (const Node& node : this->tree_.nodes()) {
    if (!node.isLeaf())
      continue;
    const auto& ray = this->rays_[node.leaf().firstReference() % this->rays_.size()];
    Hit<TypeParam> expected;
    for (const std::uint32_t face : this->tree_.references(node.leaf())) {
      auto hit = this->tree_.object(face).intersect(ray, ray.tMin, ray.tMax);
      if (!hit || !pointsSomewhere(ray))
        continue;
      hit->geometry = 0;
      hit->primitive = face;
      if (isBefore(*hit, expected))
        expected = *hit;
    }
    Hit<TypeParam> hit;
    const bool found = findIntersection(node.leaf(), view, ray, hit, ray.tMin, ray.tMax);
    EXPECT_EQ(found, expected.primitive != kNoId);
    EXPECT_EQ(hit, expected);

    Hit<TypeParam> better;
    better.t = -std::numeric_limits<TypeParam>::infinity();
    const Hit<TypeParam> before = better;
    EXPECT_FALSE(findIntersection(node.leaf(), view, ray, better, ray.tMin, ray.tMax));
    EXPECT_EQ(better, before);
  }
}

TYPED_TEST(NodeIntersection, FindsANearerHitInTheFarChild) {
  // Both triangles are in the near leaf; the hit found there lies beyond the plane, and the far
  // leaf holds a nearer one.
  using T = TypeParam;
  TriangleMesh<T> mesh;
  detail::addTriangle<T>(mesh, {T(-1), -1, -1}, {T(3), -1, 3}, {T(3), 1, 3});
  detail::addTriangle<T>(mesh, {T(1), -1, -1}, {T(1), -1, 3}, {T(1), 1, 3});
  detail::addTriangle<T>(mesh, {T(1), -1, -1}, {T(1), 1, 3}, {T(1), 1, -1});
  BuildOptions options;
  options.leafSize = 0;
  options.stopsByCost = false;
  const auto tree = buildTree(mesh.view(), options);
  const Ray<T> ray{{-5, T(-0.5), T(2.5)}, {1, 0, 0}};
  EXPECT_EQ(tree.findIntersection(ray), bruteForce(tree, ray));
  ASSERT_TRUE(tree.findIntersection(ray));
  EXPECT_EQ(tree.findIntersection(ray)->t, T(6));
}

TYPED_TEST(NodeIntersection, BreaksTiesByGeometryThenPrimitive) {
  using T = TypeParam;
  TriangleMesh<T> triangle;
  detail::addTriangle<T>(triangle, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  TriangleMesh<T> twice = triangle;
  detail::append(twice, triangle);
  Scene<T> scene;
  scene.add(TriangleMesh<T>{});
  scene.add(twice);
  scene.add(triangle);
  const auto tree = buildTree(scene);
  const auto hit = tree.findIntersection({{T(0.25), T(0.25), 1}, {0, 0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->geometry, 1u);
  EXPECT_EQ(hit->primitive, 0u);
}

TYPED_TEST(NodeIntersection, HidesGeometriesWhoseMaskSharesNoBit) {
  using T = TypeParam;
  Scene<T> scene;
  TriangleMesh<T> nearer;
  detail::addTriangle<T>(nearer, {0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  TriangleMesh<T> farther;
  detail::addTriangle<T>(farther, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  int data = 0;
  scene.add(nearer, {.mask = 1, .userPointer = &data});
  scene.add(farther, {.mask = 6});
  const auto tree = buildTree(scene);
  const Ray<T> ray{{T(0.25), T(0.25), 2}, {0, 0, -1}};
  EXPECT_EQ(tree.findIntersection(ray)->geometry, 0u);
  EXPECT_EQ(tree.findIntersection(ray, {.mask = 2})->geometry, 1u);
  EXPECT_EQ(tree.findIntersection(ray, {.mask = 8}), std::nullopt);
  EXPECT_FALSE(tree.isOccluded(ray, {.mask = 8}));
  EXPECT_TRUE(tree.isOccluded(ray, {.mask = 4}));
  EXPECT_EQ(tree.userPointer(0), &data);
  EXPECT_EQ(tree.userPointer(1), nullptr);
}

TYPED_TEST(NodeIntersection, CountsStepsWithoutChangingTheAnswer) {
  StepCounts nearest;
  StepCounts any;
  for (const auto& ray : this->rays_) {
    EXPECT_EQ(this->tree_.findIntersection(ray, nearest), this->tree_.findIntersection(ray));
    EXPECT_EQ(this->tree_.isOccluded(ray, any), this->tree_.isOccluded(ray));
  }
  EXPECT_GT(nearest.splitNodes, nearest.leafNodes / 2);
  EXPECT_GT(nearest.objects, 0u);
  EXPECT_LT(any.objects, nearest.objects);
  EXPECT_LT(any.splitNodes, nearest.splitNodes);

  StepCounts miss;
  EXPECT_FALSE(this->tree_.findIntersection({{5, 5, 5}, {1, 0, 0}}, miss));
  EXPECT_EQ(miss.splitNodes + miss.leafNodes + miss.objects, 0u);
}

TYPED_TEST(NodeIntersection, AnAxisParallelRayWithInfiniteReachVisitsFewLeaves) {
  const auto mesh = detail::grid<TypeParam>(64, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  const auto tree = buildTree(mesh.view());
  StepCounts steps;
  EXPECT_TRUE(tree.findIntersection({{TypeParam(0.01), TypeParam(0.02), 5}, {0, 0, -1}}, steps));
  EXPECT_LT(steps.leafNodes, 8u);
  EXPECT_LT(steps.objects, 40u);
}

TYPED_TEST(NodeIntersection, AllocatesNothing) {
  std::size_t hits = 0;
  const std::size_t before = allocationCount;
  for (const auto& ray : this->rays_) {
    hits += this->tree_.findIntersection(ray).has_value() ? 1u : 0u;
    hits += this->tree_.isOccluded(ray) ? 1u : 0u;
  }
  EXPECT_EQ(allocationCount, before);
  EXPECT_GT(hits, 0u);
}

}  // namespace
}  // namespace planetree::test
