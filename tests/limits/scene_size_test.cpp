#include <planetree/node/validate_tree.hpp>
#include <planetree/planetree.hpp>

#include "support/brute_force.hpp"
#include "support/build_variants.hpp"
#include "support/closed_meshes.hpp"
#include "support/compare_batches.hpp"
#include "support/hard_cases.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// How small, large and far off a scene can be.
namespace planetree::test {
namespace {

template <class T>
class SceneSize : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SceneSize, Scalars);

/// A mesh that is a bit more than 1 across.
template <class T>
TriangleMesh<T> unitSoup() {
  return detail::scaled(detail::soup<T>(911, 300, 0.3), T(0.5));
}

// Powers of two round nothing, as long as nothing over- or underflows.
TYPED_TEST(SceneSize, ScaledByAPowerOfTwoWithinTheRangeScalesEveryHit) {
  using T = TypeParam;
  const TriangleMesh<T> mesh = unitSoup<T>();
  const auto tree = buildTree(mesh.view());
  const auto rays = hardRays(mesh, tree.bounds(), 600, 912);
  for (int exponent = -30; exponent < 30; exponent += exponent == -30 || exponent == 28 ? 1 : 3) {
    SCOPED_TRACE("2^" + std::to_string(exponent) + ", " + describeSeed());
    const T scale = std::ldexp(T(1), exponent);
    const auto scaledTree = buildTree(detail::scaled(mesh, scale));
    EXPECT_EQ(scaledTree.report().sceneRange, SceneRange::Within);
    std::vector<Ray<T>> scaledRays;
    std::size_t hitCount = 0;
    for (Ray<T> ray : rays) {
      auto expected = tree.findIntersection(ray);
      // A direction of the same length takes as much longer as the scene is larger.
      ray.origin = ray.origin * scale;
      ray.tMin *= scale;
      ray.tMax *= scale;
      if (expected)
        expected->t *= scale;
      ASSERT_EQ(scaledTree.findIntersection(ray), expected) << describeRay(ray);
      ASSERT_EQ(scaledTree.isOccluded(ray), expected.has_value()) << describeRay(ray);
      hitCount += expected ? 1u : 0u;
      scaledRays.push_back(ray);
    }
    EXPECT_GT(hitCount, rays.size() / 5);
    expectSameAsAlone(scaledTree.view(), scaledRays);
  }
}

/// A closed cube between these two corners.
template <class T>
TriangleMesh<T> cubeBetween(const Vec3d& lower, const Vec3d& upper) {
  const TriangleMesh<double> unit = gridCube(8);
  TriangleMesh<T> mesh;
  mesh.faces = unit.faces;
  for (const Vec3d& position : unit.positions) {
    Vec3d corner;
    for (const Axis axis : kAxes)
      corner[axis] = lower[axis] + (upper[axis] - lower[axis]) * (0.5 * position[axis] + 0.5);
    mesh.positions.push_back(static_cast<Vec3<T>>(corner));
  }
  return mesh;
}

/// Rays from inside at all vertices, and the middles of all edges.
template <class T>
std::vector<Ray<T>> raysFromInside(const TriangleMesh<T>& mesh, const Box3& bounds) {
  Random random(913);
  const auto lower = static_cast<Vec3d>(bounds.lower);
  const Vec3d size = static_cast<Vec3d>(bounds.upper) - lower;
  std::vector<Ray<T>> rays;
  for (const auto& [a, b, c] : mesh.faces) {
    const auto from = random.pointIn<T>(lower + size * 0.3, lower + size * 0.7);
    rays.push_back({from, mesh.positions[a] - from});
    rays.push_back({from, mesh.positions[a] * T(0.5) + mesh.positions[b] * T(0.5) - from});
  }
  return rays;
}

template <class T>
void expectNoLeak(const TriangleMesh<T>& mesh) {
  const auto tree = buildTree(mesh.view());
  EXPECT_EQ(tree.report().sceneRange, SceneRange::Within);
  const auto rays = raysFromInside(mesh, tree.bounds());
  for (const Ray<T>& ray : rays) {
    ASSERT_TRUE(tree.findIntersection(ray)) << describeRay(ray) << ", " << describeSeed();
    ASSERT_TRUE(tree.isOccluded(ray)) << describeRay(ray) << ", " << describeSeed();
  }
  expectSameAsAlone(tree.view(), rays);
}

TYPED_TEST(SceneSize, OfTheEndsOfTheRangeLosesNoRayInsideAClosedMesh) {
  using T = TypeParam;
  for (const double size : {0x1p-30, 0x1p30}) {
    SCOPED_TRACE(size);
    const double half = size / 2;
    expectNoLeak(cubeBetween<T>({-half, -half, -half}, {half, half, half}));
    expectNoLeak(cubeBetween<T>({0, 0, 0}, {size, size, size}));
    expectNoLeak(cubeBetween<T>({-size, -half, 0}, {0, half, size * 0.25}));
  }
  // Far off, as large as 64 steps of float there.
  for (const double sign : {-1.0, 1.0}) {
    const double end = sign * 0x1p30;
    const double begin = sign * (0x1p30 - 64 * 0x1p6);
    const double lower = std::min(begin, end);
    const double upper = std::max(begin, end);
    expectNoLeak(cubeBetween<T>({lower, lower, lower}, {upper, upper, upper}));
  }
}

template <class T>
SceneRange rangeOfCube(const Vec3d& lower, const Vec3d& upper) {
  return buildTree(cubeBetween<T>(lower, upper)).report().sceneRange;
}

TYPED_TEST(SceneSize, OutsideOfTheRangeIsReported) {
  using T = TypeParam;
  const T above = T(1) + std::numeric_limits<float>::epsilon();
  const double large = 0x1p30;
  EXPECT_EQ(rangeOfCube<T>({0, 0, 0}, {large, large, large}), SceneRange::Within);
  EXPECT_EQ(rangeOfCube<T>({0, 0, 0}, {1, 1, large * above}), SceneRange::TooLarge);
  EXPECT_EQ(rangeOfCube<T>({-large, 0, 0}, {1024, 1, 1}), SceneRange::TooLarge);
  EXPECT_EQ(rangeOfCube<T>({large, large, large}, {large + 1024, large + 1024, large + 1024}),
            SceneRange::TooFar);
  EXPECT_EQ(rangeOfCube<T>({-large - 1024, 0, 0}, {-large, 1, 1}), SceneRange::TooFar);
  const double small = 0x1p-30;
  EXPECT_EQ(rangeOfCube<T>({0, 0, 0}, {small, small / 4, 0}), SceneRange::Within);
  EXPECT_EQ(rangeOfCube<T>({0, 0, 0}, {small / above, small / 4, 0}), SceneRange::TooSmall);
  EXPECT_EQ(rangeOfCube<T>({0, 0, 0}, {0x1p-126, 0x1p-126, 0x1p-126}), SceneRange::TooSmall);
  EXPECT_EQ(buildTree(TriangleMesh<T>{}).report().sceneRange, SceneRange::Within);
}

TEST(SceneSizeOfShapes, OutsideOfTheRangeIsReported) {
  const auto rangeOf = [](const Sphere<double>& sphere) {
    Scene<double> scene;
    scene.add(TriangleMesh<double>{});
    scene.add(sphere);
    return buildTree(scene).report().sceneRange;
  };
  EXPECT_EQ(rangeOf({{0, 0, 0}, 1}), SceneRange::Within);
  EXPECT_EQ(rangeOf({{0, 0, 0}, 0x1p31}), SceneRange::TooLarge);
  EXPECT_EQ(rangeOf({{0, 0, 0}, 0x1p-40}), SceneRange::TooSmall);
  EXPECT_EQ(rangeOf({{0, 0x1p40, 0}, 0x1p20}), SceneRange::TooFar);
}

// Only what is in the tree counts.
TEST(SceneSizeOfShapes, LeavesSkippedObjectsAside) {
  TriangleMesh<float> mesh = unitSoup<float>();
  detail::addTriangle(mesh, {0, 0, 0}, {0, 0, 0}, {0x1p100f, 0, 0});
  const auto tree = buildTree(mesh);
  EXPECT_EQ(tree.report().skippedCount, 1u);
  EXPECT_EQ(tree.report().sceneRange, SceneRange::Within);
}

/// Asks all there is to ask, and looks at no answer.
template <class T>
void askEverything(const KdTree<Face<T>>& tree, const std::vector<Ray<T>>& rays) {
  std::vector<Hit<T>> hits(rays.size());
  std::vector<std::uint8_t> flags(rays.size());
  static_cast<void>(tree.findIntersections(rays, hits));
  static_cast<void>(tree.areOccluded(rays, flags));
  for (const Ray<T>& ray : rays) {
    static_cast<void>(tree.findIntersection(ray));
    static_cast<void>(tree.isOccluded(ray));
    static_cast<void>(tree.findIntersections(ray, hits));
    static_cast<void>(tree.findIntersections(ray, hits, {.crossings = true}));
    Hit<T> hit;
    static_cast<void>(tree.findIntersection(tree.root(), ray, hit, ray.tMin, ray.tMax));
    static_cast<void>(tree.explainIntersection(ray));
  }
}

TYPED_TEST(SceneSize, BeyondTheRangeCrashesNothing) {
  using T = TypeParam;
  std::uint64_t salt = 914;
  for (const int exponent : {-160, -149, -130, -126, -100, -64, -40, 40, 64, 100, 125, 126, 140}) {
    SCOPED_TRACE("2^" + std::to_string(exponent) + ", " + describeSeed());
    const auto mesh = detail::scaled(unitSoup<T>(), static_cast<T>(std::exp2(exponent)));
    for (const auto& [variant, options] : buildVariants()) {
      const auto tree = buildTree(mesh.view(), options);
      const auto problem =
          validateTree(tree.nodes(), tree.view().references, tree.bounds(), tree.objectCount());
      EXPECT_FALSE(problem) << *problem << ", " << variant;
      EXPECT_TRUE(tree.report().sceneRange != SceneRange::Within ||
                  tree.report().skippedCount == tree.report().objectCount);
      auto rays = hardRays(mesh, tree.bounds(), 60, ++salt);
      const auto invalid = invalidRays<T>();
      rays.insert(rays.end(), invalid.begin(), invalid.end());
      askEverything(tree, rays);
    }
  }
}

}  // namespace
}  // namespace planetree::test
