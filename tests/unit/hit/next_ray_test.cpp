#include <planetree/hit/next_ray.hpp>

#include <planetree/planetree.hpp>

#include "mesh/triangle_hit.hpp"
#include "support/closed_meshes.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace planetree::test {
namespace {

template <class T>
class NextRay : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(NextRay, Scalars);

template <class T>
using Corners = std::array<Vec3<T>, 3>;

/// A triangle of any size, shape and place within docs/limits.md.
template <class T>
Corners<T> anyTriangle(Random& random) {
  const double scale = std::exp2(random.between(-30, 29));
  const double width = random.chance(0.5) ? 1.0 : std::exp2(random.between(-20, 0));
  const double farAway = random.chance(0.5) ? 0.0 : std::exp2(random.between(0, 10));
  const Vec3d place = random.direction() * (std::min(farAway * scale, 0x1p29));
  const Vec3d edge = random.chance(0.8) ? random.direction() : Vec3d{1, 0, 0};
  const Vec3d a = random.pointIn<double>({-1, -1, -1}, {1, 1, 1});
  const Vec3d b = a + edge * random.between(0.1, 2.0);
  const Vec3d c = a + edge * random.unit() + random.direction() * width;
  Corners<T> corners;
  for (std::size_t i = 0; const Vec3d& corner : {a, b, c})
    corners[i++] = static_cast<Vec3<T>>(corner * scale + place);
  return corners;
}

template <class T>
Box3 boundsOf(const Corners<T>& corners) {
  Box3 bounds;
  for (const Vec3<T>& corner : corners)
    bounds.extend(corner);
  return bounds;
}

template <class T>
Vec3<T> pointInside(const Corners<T>& corners, Random& random) {
  const double u = random.unit();
  const double v = random.unit() * (1.0 - u);
  return static_cast<Vec3<T>>(static_cast<Vec3d>(corners[0]) * (1.0 - u - v) +
                              static_cast<Vec3d>(corners[1]) * u +
                              static_cast<Vec3d>(corners[2]) * v);
}

/// A ray at the triangle, from near or from up to a thousand times its size away.
template <class T>
Ray<T> rayAt(const Corners<T>& corners, Random& random) {
  const double size = length(static_cast<Vec3d>(corners[1] - corners[0]));
  const double distance = size * std::exp2(random.between(-5, 10));
  const Vec3<T> target = pointInside(corners, random);
  const auto origin =
      static_cast<Vec3<T>>(static_cast<Vec3d>(target) + random.direction() * distance);
  return {origin, target - origin};
}

/// Anywhere, or toward another point of the same triangle, which is as near to its plane as
/// rounding allows.
template <class T>
Vec3<T> anyDirection(const Corners<T>& corners, const Vec3<T>& from, Random& random) {
  const auto scale = static_cast<T>(std::exp2(random.between(-10, 10)));
  if (random.chance(0.5))
    return static_cast<Vec3<T>>(random.direction()) * scale;
  const Vec3<T> along = pointInside(corners, random) - from;
  const auto tilt = static_cast<T>(std::exp2(random.between(-60, 0)) * random.between(-1, 1));
  return along + static_cast<Vec3<T>>(random.direction()) * (tilt * length(along));
}

TYPED_TEST(NextRay, NeverHitsTheTriangleItLeaves) {
  using T = TypeParam;
  Random random(51);
  std::uint64_t hitCount = 0;
  for (int i = 0; i < 2'000'000; ++i) {
    const Corners<T> corners = anyTriangle<T>(random);
    const auto& [a, b, c] = corners;
    const auto corner = static_cast<Vec3d>(a);
    const bool isOnALine =
        cross(static_cast<Vec3d>(b) - corner, static_cast<Vec3d>(c) - corner) == Vec3d{};
    if (isOnALine)  // rounding has put it there; it has no sides
      continue;
    const Ray<T> ray = rayAt(corners, random);
    const T infinity = std::numeric_limits<T>::infinity();
    const auto hit =
        planetree::detail::findTriangleHit(ShearedRay<T>(ray), a, b, c, T(0), infinity);
    if (!hit)
      continue;
    ++hitCount;
    const Vec3<T> point = ray.at(hit->t);
    const Vec3<T> direction = anyDirection(corners, point, random);
    if (direction == Vec3<T>{})
      continue;
    const Box3 bounds = boundsOf(corners);
    const Ray<T> next = nextRay(ray, *hit, direction, bounds);
    ASSERT_FALSE(intersectTriangle(ShearedRay<T>(next), a, b, c, next.tMin, next.tMax))
        << "triangle " << i << ", " << describeSeed();

    // Ten roundoffs of every distance there is, and the square root of 3 for the slope.
    const T reach = planetree::detail::largestDistance(ray.origin, bounds) +
                    planetree::detail::largestDistance(point, bounds) + length(point);
    ASSERT_LE(length(next.origin - point), T(32) * std::numeric_limits<T>::epsilon() * reach);
    ASSERT_EQ(next.direction, direction);
  }
  EXPECT_GT(hitCount, 1'000'000u);
}

TYPED_TEST(NextRay, BeginsOnTheSideItGoesTo) {
  using T = TypeParam;
  const Box3 bounds{{-1, -1, 0}, {1, 1, 0}};
  const Ray<T> ray{{0, 0, 3}, {0, 0, -1}};
  const Hit<T> hit{.t = T(3), .normal = {0, 0, 1}, .geometry = 0, .primitive = 0};
  EXPECT_GT(nextRay(ray, hit, {T(0.1), 0, 1}, bounds).origin.z, T(0));
  EXPECT_LT(nextRay(ray, hit, {T(0.1), 0, -1}, bounds).origin.z, T(0));
}

TYPED_TEST(NextRay, StaysInsideAClosedMeshFromWhichItIsReflected) {
  using T = TypeParam;
  Random random(52);
  for (const ClosedMesh<T>& closed : closedMeshes<T>()) {
    const KdTree<Face<T>> tree = buildTree(closed.mesh.view());
    Ray<T> ray{closed.center, static_cast<Vec3<T>>(random.direction())};
    Hit<T> last;
    for (int i = 0; i < 20'000; ++i) {
      const auto hit = tree.findIntersection(ray);
      ASSERT_TRUE(hit) << closed.name << ", bounce " << i << ", " << describeSeed();
      ASSERT_NE(hit->primitive, last.primitive) << closed.name << ", bounce " << i;
      // Again and again back to the middle, or the ray ends in a corner.
      const Vec3<T> inward = closed.center - ray.at(hit->t);
      const Vec3<T> aside = static_cast<Vec3<T>>(random.direction()) * (closed.innerRadius / T(2));
      ray = nextRay(ray, *hit, inward + aside, tree.bounds());
      last = *hit;
    }
  }
}

TYPED_TEST(NextRay, LeavesRoundShapesOutward) {
  using T = TypeParam;
  Random random(53);
  for (int i = 0; i < 100'000; ++i) {
    const Sphere<T> sphere{random.pointIn<T>({-5, -5, -5}, {5, 5, 5}),
                           static_cast<T>(std::exp2(random.between(-5, 3)))};
    const auto outside =
        sphere.center + static_cast<Vec3<T>>(random.direction()) *
                            (sphere.radius * static_cast<T>(random.between(2, 50)));
    const Vec3<T> target =
        sphere.center + static_cast<Vec3<T>>(random.direction()) * sphere.radius * T(0.9);
    const Ray<T> ray{outside, target - outside};
    const auto hit = sphere.intersect(ray, T(0), std::numeric_limits<T>::infinity());
    ASSERT_TRUE(hit);
    auto direction = static_cast<Vec3<T>>(random.direction());
    if (dot(direction, hit->normal) < T(0))
      direction = -direction;
    const Ray<T> next = nextRay(ray, *hit, direction, sphere.bounds());
    ASSERT_FALSE(sphere.intersect(next, next.tMin, next.tMax)) << i << ", " << describeSeed();
  }
}

}  // namespace
}  // namespace planetree::test
