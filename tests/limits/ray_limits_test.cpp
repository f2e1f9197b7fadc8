#include <planetree/planetree.hpp>

#include "support/brute_force.hpp"
#include "support/closed_meshes.hpp"
#include "support/compare_batches.hpp"
#include "support/hard_cases.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

/// What a ray can be like: its origin, its direction, and its ends.
namespace planetree::test {
namespace {

template <class T>
class RayLimits : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(RayLimits, Scalars);

/// The nearest hit as every kind of query has it, if they agree.
template <class T>
std::optional<Hit<T>> nearestHit(const KdTree<Face<T>>& tree, const Ray<T>& ray) {
  const auto hit = tree.findIntersection(ray);
  const Hit<T> expected = hit.value_or(Hit<T>{});
  EXPECT_EQ(hit, bruteForce(tree, ray)) << describeRay(ray);
  EXPECT_EQ(tree.isOccluded(ray), hit.has_value()) << describeRay(ray);
  Hit<T> byNode;
  EXPECT_EQ(tree.findIntersection(tree.root(), ray, byNode, ray.tMin, ray.tMax), hit.has_value());
  EXPECT_EQ(byNode, expected) << describeRay(ray);
  std::array<Hit<T>, 1> first;
  EXPECT_EQ(tree.findIntersections(ray, first).count, hit ? 1u : 0u) << describeRay(ray);
  if (hit) {
    EXPECT_EQ(first[0], expected) << describeRay(ray);
  }
  // More of them than are answered one by one.
  expectSameAsAlone(tree.view(), std::vector<Ray<T>>(20, ray));
  return hit;
}

TYPED_TEST(RayLimits, ScalingTheDirectionByAPowerOfTwoScalesEveryT) {
  using T = TypeParam;
  const TriangleMesh<T> mesh = detail::soup<T>(921, 300, 0.3);
  const auto tree = buildTree(mesh.view());
  Random random(922);
  std::vector<Ray<T>> rays;
  for (int i = 0; i < 300; ++i) {
    const auto origin = random.pointIn<T>({-2, -2, -2}, {2, 2, 2});
    rays.push_back({origin, random.pointIn<T>({-1, -1, -1}, {1, 1, 1}) - origin});
  }
  for (const int exponent : {-60, -59, -41, -40, -39, -20, -1, 1, 20, 39, 40, 41, 59, 60}) {
    SCOPED_TRACE(testing::Message() << "2^" << exponent << ", " << describeSeed());
    const T scale = std::ldexp(T(1), exponent);
    std::vector<Ray<T>> scaled;
    std::size_t hitCount = 0;
    for (const Ray<T>& ray : rays) {
      auto expected = tree.findIntersection(ray);
      scaled.push_back({ray.origin, ray.direction * scale});
      if (expected)
        expected->t /= scale;
      hitCount += expected ? 1u : 0u;
      ASSERT_EQ(tree.findIntersection(scaled.back()), expected) << describeRay(ray);
      ASSERT_EQ(tree.isOccluded(scaled.back()), expected.has_value()) << describeRay(ray);
    }
    EXPECT_GT(hitCount, rays.size() / 5);
    expectSameAsAlone(tree.view(), scaled);
  }
}

TYPED_TEST(RayLimits, RaysThatPointNowhereOrComeFromNowhereMiss) {
  using T = TypeParam;
  TriangleMesh<T> mesh;
  detail::addTriangle<T>(mesh, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  const auto tree = buildTree(mesh);
  for (const Ray<T>& ray : invalidRays<T>())
    EXPECT_EQ(nearestHit(tree, ray), std::nullopt) << describeRay(ray);
  constexpr T kNaN = std::numeric_limits<T>::quiet_NaN();
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  for (const T bad : {kNaN, -kNaN, kInfinity, -kInfinity}) {
    for (const Axis axis : kAxes) {
      Ray<T> ray{{0, 0, 5}, {0, 0, -1}};
      ray.direction[axis] = bad;
      EXPECT_EQ(nearestHit(tree, ray), std::nullopt) << describeRay(ray);
      ray = {{0, 0, 5}, {0, 0, -1}};
      ray.origin[axis] = bad;
      EXPECT_EQ(nearestHit(tree, ray), std::nullopt) << describeRay(ray);
    }
  }
}

// The triangle is hit at t = 5.
TYPED_TEST(RayLimits, TheIntervalIsClosedAndItsEndsMayBeInfinite) {
  using T = TypeParam;
  TriangleMesh<T> mesh;
  detail::addTriangle<T>(mesh, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  const auto tree = buildTree(mesh);
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  constexpr T kLargest = std::numeric_limits<T>::max();
  constexpr T kSmallest = std::numeric_limits<T>::denorm_min();
  const T below = std::nextafter(T(5), T(0));
  const T above = std::nextafter(T(5), kInfinity);
  const auto isHit = [&](T tMin, T tMax) {
    const auto hit = nearestHit<T>(tree, {{0, 0, 5}, {0, 0, -1}, tMin, tMax});
    EXPECT_TRUE(!hit || hit->t == T(5));
    return hit.has_value();
  };
  EXPECT_TRUE(isHit(0, kInfinity));
  EXPECT_TRUE(isHit(-kInfinity, kInfinity));
  EXPECT_TRUE(isHit(-kLargest, kLargest));
  EXPECT_TRUE(isHit(-kInfinity, 5));
  EXPECT_TRUE(isHit(5, 5));
  EXPECT_TRUE(isHit(5, kInfinity));
  EXPECT_TRUE(isHit(below, above));
  EXPECT_TRUE(isHit(kSmallest, kLargest));
  EXPECT_FALSE(isHit(0, below));
  EXPECT_FALSE(isHit(above, kInfinity));
  EXPECT_FALSE(isHit(above, below));
  EXPECT_FALSE(isHit(6, 4));
  EXPECT_FALSE(isHit(0, -0.0));
  EXPECT_FALSE(isHit(0, kSmallest));
  EXPECT_FALSE(isHit(-kInfinity, -kInfinity));
  EXPECT_FALSE(isHit(kInfinity, kInfinity));
  EXPECT_FALSE(isHit(kInfinity, -kInfinity));
}

TYPED_TEST(RayLimits, AnEndThatIsNaNMisses) {
  using T = TypeParam;
  TriangleMesh<T> mesh;
  detail::addTriangle<T>(mesh, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  const auto tree = buildTree(mesh);
  constexpr T kNaN = std::numeric_limits<T>::quiet_NaN();
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  const std::array<std::array<T, 2>, 5> ends = {
      {{kNaN, kInfinity}, {0, kNaN}, {kNaN, kNaN}, {-kNaN, 10}, {-kInfinity, -kNaN}}};
  for (const auto& [tMin, tMax] : ends)
    EXPECT_EQ(nearestHit<T>(tree, {{0, 0, 5}, {0, 0, -1}, tMin, tMax}), std::nullopt);
}

// A hit where the ray begins, and hits behind the origin.
TYPED_TEST(RayLimits, HitsAtZeroAndBehindTheOriginCountIfTheIntervalHoldsThem) {
  using T = TypeParam;
  TriangleMesh<T> mesh;
  detail::addTriangle<T>(mesh, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  const auto tree = buildTree(mesh);
  for (const T end : {T(0), T(-0.0)}) {
    const auto hit = nearestHit<T>(tree, {{0, 0, 0}, {0, 0, -1}, end, end});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, T(0));
  }
  EXPECT_FALSE(nearestHit<T>(tree, {{0, 0, -3}, {0, 0, -1}}));
  EXPECT_TRUE(nearestHit<T>(tree, {{0, 0, -3}, {0, 0, -1}, -3, 0}));
  EXPECT_TRUE(
      nearestHit<T>(tree, {{0, 0, -3}, {0, 0, -1}, -std::numeric_limits<T>::infinity(), -3}));
}

/// Places at this distance along axes and diagonals.
std::vector<Vec3d> placesAt(double distance) {
  std::vector<Vec3d> places;
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      for (const double z : {-1.0, 0.0, 1.0}) {
        if (x != 0.0 || y != 0.0 || z != 0.0)
          places.push_back(Vec3d{x, y, z} * distance);
      }
    }
  }
  return places;
}

// From there a step of the origin's numbers is larger than most of these scenes, and yet the tree
// answers as if every triangle were asked.
TYPED_TEST(RayLimits, FromTheFarthestOriginsTheTreeAgreesWithBruteForce) {
  using T = TypeParam;
  Random random(923);
  for (const double size : {0x1p-30, 0x1p-10, 1.0, 0x1p10, 0x1p20, 0x1p29}) {
    const auto mesh = detail::scaled(detail::soup<T>(924, 100, 0.3), static_cast<T>(size * 0.5));
    const auto tree = buildTree(mesh.view());
    for (const double distance : {0x1p30, 0x1p39, 0x1p40}) {
      SCOPED_TRACE(testing::Message() << size << " from " << distance << ", " << describeSeed());
      for (const Vec3d& place : placesAt(distance - size)) {
        const auto origin = static_cast<Vec3<T>>(place);
        const Vec3d target = random.pointIn<double>({-1, -1, -1}, {1, 1, 1}) * (0.5 * size);
        const auto aimed = static_cast<Vec3<T>>(target - place);
        for (const Vec3<T>& direction :
             {aimed, -origin, aimed * static_cast<T>(0x1p-60), aimed * static_cast<T>(0x1p19)})
          static_cast<void>(nearestHit<T>(tree, {origin, direction}));
      }
    }
  }
}

// What lies well inside of the outline is hit from there, too.
TYPED_TEST(RayLimits, FromTheFarthestOriginsLargeClosedMeshesAreHit) {
  using T = TypeParam;
  Random random(925);
  // In float the place of a hit is off by up to 2^19 from there, in double hardly at all.
  const double smallest = std::is_same_v<T, float> ? 0x1p24 : 1.0;
  for (double size = smallest; size <= 0x1p30; size *= 8) {
    const auto cube = placed<T>("", gridCube(8), size * 0.5, {}, 0.0).mesh;
    const auto tree = buildTree(cube.view());
    for (const double distance : {0x1p36, 0x1p40}) {
      SCOPED_TRACE(testing::Message() << size << " from " << distance << ", " << describeSeed());
      std::vector<Ray<T>> rays;
      for (const Vec3d& place : placesAt(distance - size)) {
        for (int i = 0; i < 8; ++i) {
          // The cube's smallest outline has a radius of half of its size.
          const Vec3d target = random.direction() * (0.35 * size * random.unit());
          rays.push_back({static_cast<Vec3<T>>(place), static_cast<Vec3<T>>(target - place)});
        }
      }
      for (const Ray<T>& ray : rays) {
        ASSERT_TRUE(tree.findIntersection(ray)) << describeRay(ray);
        ASSERT_TRUE(tree.isOccluded(ray)) << describeRay(ray);
      }
      expectSameAsAlone(tree.view(), rays);
    }
  }
}

}  // namespace
}  // namespace planetree::test
