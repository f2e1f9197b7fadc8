#include <planetree/planetree.hpp>

#include "support/brute_force.hpp"
#include "support/compare_batches.hpp"
#include "support/hard_cases.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

/// The deepest trees, the largest leaves, and none at all.
namespace planetree::test {
namespace {

template <class T>
class TreeForm : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(TreeForm, Scalars);

/// Triangles of which each is half as large as the last, all in one corner: every level of a tree
/// can cut one off.
template <class T>
TriangleMesh<T> nestedTriangles() {
  TriangleMesh<T> mesh;
  for (int i = 0; i < 100; ++i) {
    const T size = std::ldexp(T(1), 20 - i);
    detail::addTriangle<T>(mesh, {size, 0, 0}, {0, size, 0}, {0, 0, size});
  }
  return mesh;
}

BuildOptions asDeepAsPossible() {
  BuildOptions options;
  options.depthLimit = kMaxTreeDepth;
  options.leafSize = 0;
  options.cost = {.traversalCost = 0.0, .intersectionCost = 1.0, .emptyBonus = 0.0};
  options.referencesPerObject = 0;
  return options;
}

TYPED_TEST(TreeForm, OfTheGreatestDepthAnswersAsBruteForceDoes) {
  using T = TypeParam;
  const TriangleMesh<T> mesh = nestedTriangles<T>();
  const auto tree = buildTree(mesh.view(), asDeepAsPossible());
  ASSERT_EQ(tree.statistics().depth, kMaxTreeDepth);
  Random random(931);
  std::vector<Ray<T>> rays = hardRays(mesh, tree.bounds(), 300, 932);
  for (int i = 0; i < 300; ++i) {
    // Through the corner where all levels are, or past it.
    const double near = std::exp2(random.between(-60, 20));
    const auto target = random.pointIn<T>({0, 0, 0}, {near, near, near});
    const auto origin = random.pointIn<T>({-1e6, -1e6, -1e6}, {1e6, 1e6, 1e6});
    rays.push_back({origin, target - origin});
    rays.push_back({target, static_cast<Vec3<T>>(random.direction())});
  }
  std::size_t hitCount = 0;
  std::array<Hit<T>, 200> hits;
  for (const Ray<T>& ray : rays) {
    const auto expected = bruteForce(tree, ray);
    ASSERT_EQ(tree.findIntersection(ray), expected) << describeRay(ray);
    ASSERT_EQ(tree.isOccluded(ray), expected.has_value()) << describeRay(ray);
    Hit<T> hit;
    ASSERT_EQ(tree.findIntersection(tree.root(), ray, hit, ray.tMin, ray.tMax),
              expected.has_value());
    ASSERT_EQ(hit, expected.value_or(Hit<T>{})) << describeRay(ray);
    ASSERT_EQ(tree.findIntersections(ray, hits).count > 0, expected.has_value());
    hitCount += expected ? 1u : 0u;
  }
  EXPECT_GT(hitCount, rays.size() / 10);
  expectSameAsAlone(tree.view(), rays);
}

// More copies than an eight-byte word of a careless tree could count in its leaf.
TYPED_TEST(TreeForm, OfOneLeafWithManyCopiesAnswersWithTheFirst) {
  using T = TypeParam;
  constexpr std::uint32_t kCopyCount = 200'000;
  TriangleMesh<T> mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  mesh.faces.assign(kCopyCount, {0, 1, 2});
  const auto tree = buildTree(mesh.view());
  ASSERT_EQ(tree.statistics().largestLeaf, kCopyCount);
  const Ray<T> ray{{T(0.1), T(0.2), 3}, {0, 0, -1}};
  const auto hit = tree.findIntersection(ray);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->primitive, 0u);
  EXPECT_EQ(hit->t, T(3));
  std::vector<Hit<T>> hits(kCopyCount + 1);
  EXPECT_EQ(tree.findIntersections(ray, hits), (FoundHits{kCopyCount, false}));
  for (std::uint32_t i = 0; i < kCopyCount; ++i)
    ASSERT_EQ(hits[i].primitive, i);
}

TYPED_TEST(TreeForm, OfDuplicatesAnswersWithTheLowestGeometryAndPrimitive) {
  using T = TypeParam;
  const TriangleMesh<T> mesh = detail::soup<T>(933, 50, 0.5);
  TriangleMesh<T> twice = mesh;
  detail::append(twice, mesh);
  Scene<T> scene;
  scene.add(twice);
  scene.add(mesh);
  const auto once = buildTree(mesh.view());
  const auto tree = buildTree(scene);
  std::size_t hitCount = 0;
  for (const Ray<T>& ray : hardRays(mesh, once.bounds(), 400, 934)) {
    const auto hit = once.findIntersection(ray);
    ASSERT_EQ(tree.findIntersection(ray), hit) << describeRay(ray);
    if (!hit)
      continue;
    ++hitCount;
    std::array<Hit<T>, 3> all;
    ASSERT_EQ(tree.findIntersections(ray, all).count, 3u);
    // Another triangle may be hit at the same t: those come in between.
    for (std::size_t i = 1; i < 3; ++i)
      ASSERT_TRUE(isBefore(all[i - 1], all[i])) << describeRay(ray);
  }
  EXPECT_GT(hitCount, 100u);
}

TYPED_TEST(TreeForm, OfNothingIsMissedByEveryRay) {
  using T = TypeParam;
  TriangleMesh<T> bad;
  bad.positions = {{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<T>::quiet_NaN(), 0}};
  bad.faces = {{0, 1, 2}, {0, 1, 9}, {0, 0, 1}};
  for (const TriangleMesh<T>& mesh : {TriangleMesh<T>{}, bad}) {
    const auto tree = buildTree(mesh);
    ASSERT_EQ(tree.nodes().size(), 1u);
    const auto rays = hardRays(TriangleMesh<T>{}, tree.bounds(), 200, 935);
    for (const Ray<T>& ray : rays) {
      ASSERT_EQ(tree.findIntersection(ray), std::nullopt);
      ASSERT_FALSE(tree.isOccluded(ray));
      std::array<Hit<T>, 1> hits;
      ASSERT_EQ(tree.findIntersections(ray, hits).count, 0u);
    }
    std::vector<Hit<T>> hits(rays.size());
    EXPECT_EQ(tree.findIntersections(rays, hits), 0u);
  }
}

TYPED_TEST(TreeForm, KeepsTrianglesWithDenormalCoordinates) {
  using T = TypeParam;
  constexpr T kTiny = std::numeric_limits<T>::denorm_min();
  TriangleMesh<T> mesh;
  detail::addTriangle<T>(mesh, {0, 0, 0}, {kTiny, 0, 0}, {0, kTiny, 0});
  detail::addTriangle<T>(mesh, {-1, -1, kTiny}, {1, -1, -kTiny}, {0, 1, 0});
  const auto tree = buildTree(mesh);
  EXPECT_EQ(tree.report().skippedCount, 0u);
  const auto hit = tree.findIntersection({{T(0.25), T(0.25), 1}, {0, 0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->primitive, 1u);
}

}  // namespace
}  // namespace planetree::test
