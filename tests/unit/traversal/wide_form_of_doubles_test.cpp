#include <planetree/planetree.hpp>

#include "compare_forms.hpp"
#include "support/brute_force.hpp"
#include "support/closed_meshes.hpp"
#include "support/flush_to_zero.hpp"
#include "support/hard_cases.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The blocks of the wide form hold the corners of doubles rounded to float. Here is what rounding
/// could spoil.
namespace planetree::detail {
namespace {

using Mesh = TriangleMesh<double>;

/// Compares the wide form with the binary one and both with brute force; returns how many rays the
/// wide form took, over all instruction sets.
std::size_t compareAll(const Mesh& mesh, const std::vector<Rayd>& rays) {
  const auto tree = buildTree(mesh.view());
  for (const Rayd& ray : rays) {
    const std::optional<Hitd> expected = test::bruteForce(tree, ray);
    EXPECT_EQ(tree.findIntersection(ray), expected);
    EXPECT_EQ(tree.isOccluded(ray), expected.has_value());
  }
  return compareForms(tree.view(), rays);
}

/// Rays from anywhere within `reach` of a corner of a random face to that corner, to a point of an
/// edge, or to a point inside.
std::vector<Rayd> raysAtFaces(const Mesh& mesh, double reach, int count, std::uint64_t salt) {
  test::Random random(salt);
  std::vector<Rayd> rays;
  for (int i = 0; i < count; ++i) {
    const auto [a, b, c] = mesh.view().corners(random.below(mesh.faces.size()));
    const double u = random.chance(0.3) ? 0.0 : random.unit();
    const double v = random.chance(0.6) ? 0.0 : random.unit() * (1.0 - u);
    const Vec3d target = a + (b - a) * u + (c - a) * v;
    const Vec3d origin = a + random.direction() * (reach * random.unit());
    rays.push_back({origin, target - origin});
  }
  return rays;
}

/// Two soups of tiny triangles, so far apart that all corners of one round to the same float.
Mesh farClusters(double distance, double size) {
  Mesh mesh = test::detail::scaled(test::detail::soup<double>(61, 60, 0.5), size,
                                   Vec3d{distance, -distance, distance});
  test::detail::append(mesh, test::detail::scaled(test::detail::soup<double>(62, 60, 0.5), size,
                                                  Vec3d{-distance, distance, distance}));
  return mesh;
}

TEST(WideFormOfDoubles, FindsDetailThatFloatsCannotTellApart) {
  for (const double distance : {1e3, 1e6, 0x1p29}) {
    SCOPED_TRACE(distance);
    const Mesh mesh = farClusters(distance, 1e-3);
    EXPECT_GT(compareAll(mesh, raysAtFaces(mesh, 1e-2, 300, 63)), 0u);
    EXPECT_GT(compareAll(mesh, raysAtFaces(mesh, distance, 300, 64)), 0u);
  }
}

TEST(WideFormOfDoubles, IsRightFarFromTheOriginAndAtAllScales) {
  for (const double scale : {0x1p-30, 1e-3, 1.0, 1e5, 0x1p29}) {
    for (const double offset : {0.0, 1e-3, 1.0, 1e6, 0x1p29}) {
      SCOPED_TRACE(std::to_string(scale) + " at " + std::to_string(offset));
      const Mesh mesh = test::detail::scaled(test::detail::soup<double>(65, 100, 0.2), scale,
                                             Vec3d{offset, -offset, offset});
      // The smallest triangles, farthest away, are points even in double.
      const bool isVisible = scale > offset * 0x1p-50;
      const std::size_t nearCount = compareAll(mesh, raysAtFaces(mesh, scale, 100, 66));
      const std::size_t farCount = compareAll(mesh, raysAtFaces(mesh, 1e4 * scale, 50, 67));
      EXPECT_TRUE(!isVisible || (nearCount > 0 && farCount > 0));
    }
  }
}

TEST(WideFormOfDoubles, IsRightForRaysFromFarAway) {
  const Mesh mesh = test::detail::soup<double>(68, 200, 0.2);
  for (const double distance : {0x1p10, 0x1p20, 0x1p30, 0x1p38}) {
    SCOPED_TRACE(distance);
    EXPECT_GT(compareAll(mesh, raysAtFaces(mesh, distance, 100, 69)), 0u);
  }
}

TEST(WideFormOfDoubles, TellsHitsApartThatAreOneFloatFromEachOther) {
  // A pile of faces whose distances differ by less than floats do, the nearest somewhere inside.
  Mesh mesh;
  for (int i = 0; i < 64; ++i) {
    const double z = 1.0 + 1e-11 * ((i * 29) % 64);
    test::detail::addTriangle<double>(mesh, {-1, -1, z}, {1, -1, z}, {0, 1, z});
  }
  test::Random random(70);
  std::vector<Rayd> rays;
  for (int i = 0; i < 200; ++i) {
    const double x = random.between(-0.3, 0.3);
    const double start = random.between(-1e-11, 65e-11);
    const double length = random.between(0.0, 30e-11);
    rays.push_back({{x, 0, 3}, {0, 0, -1}});
    rays.push_back({{x, 0, 0}, {0, 0, 1}, 1.0 + start, 1.0 + start + length});
    rays.push_back({{x, 0, 1.0 + start}, {0, 0, 1}, 0.0, length});
    rays.push_back({{x, 0, 1.0 + start}, {1e-3, 0, -1}});
  }
  EXPECT_EQ(compareAll(mesh, rays), rays.size() * supportedKernels().size());
}

TEST(WideFormOfDoubles, FindsSliversNarrowerThanAFloat) {
  test::Random random(71);
  Mesh mesh;
  for (int i = 0; i < 200; ++i) {
    const auto a = random.pointIn<double>({-1, -1, -1}, {1, 1, 1});
    const Vec3d along = random.direction();
    const Vec3d across = random.direction() * std::exp2(random.between(-50, -10));
    test::detail::addTriangle<double>(mesh, a, a + along, a + along * random.unit() + across);
  }
  EXPECT_GT(compareAll(mesh, raysAtFaces(mesh, 3.0, 2000, 72)), 0u);
}

TEST(WideFormOfDoubles, FindsFlatScenesAcrossAndAlongTheRay) {
  const double third = 1.0 / 3.0;
  for (const Vec3d& corner : {Vec3d{third, -1, -1}, Vec3d{1e6 + third, -1, -1}}) {
    const Mesh mesh = test::detail::grid<double>(12, corner, {0, 2 + third, 0}, {0, 0, 2 + third});
    std::vector<Rayd> rays = raysAtFaces(mesh, 2.0, 400, 73);
    test::Random random(74);
    for (int i = 0; i < 200; ++i) {
      Rayd inPlane{corner, random.direction()};
      inPlane.origin.y += random.between(-1, 3);
      inPlane.direction.x = random.chance(0.5) ? 0.0 : 1e-12 * random.unit();
      rays.push_back(inPlane);
      // At right angles through a vertex, to the last bit.
      const Vec3d vertex = mesh.positions[random.below(mesh.positions.size())];
      rays.push_back({{vertex.x - 1.0, vertex.y, vertex.z}, {1, 0.0, -0.0}});
    }
    EXPECT_GT(compareAll(mesh, rays), 0u);
  }
}

TEST(WideFormOfDoubles, NearlyParallelRaysMeetTheBoxesThatTheyGraze) {
  // Directions between what floats and what doubles take for parallel to a plane.
  const Mesh mesh = test::detail::grid<double>(16, {-1, -1, -0.1}, {2, 0, 0.2}, {0, 2, 1e-9});
  test::Random random(75);
  std::vector<Rayd> rays;
  for (int i = 0; i < 600; ++i) {
    Vec3d direction{1, 0, 0};
    direction.y = std::copysign(std::exp2(random.between(-75, -20)), random.between(-1, 1));
    direction.z = std::copysign(std::exp2(random.between(-75, -2)), random.between(-1, 1));
    const Vec3d target = mesh.positions[random.below(mesh.positions.size())];
    rays.push_back({target - direction * random.between(0.0, 5.0), direction});
  }
  EXPECT_EQ(compareAll(mesh, rays), rays.size() * supportedKernels().size());
}

TEST(WideFormOfDoubles, NoRayLeavesAClosedMeshSmallerThanTheGapsOfFloats) {
  for (const test::ClosedMesh<double>& closed : test::closedMeshes<double>()) {
    if (closed.name != "icosphere" && closed.name != "star")
      continue;
    const Vec3d offset{1e6, -1e6, 5e5};
    Mesh mesh = test::detail::scaled(closed.mesh, 1e-3, offset);
    const std::size_t faceCount = mesh.faces.size();
    test::detail::addTriangle<double>(mesh, {-1e6, 0, 0}, {-1e6, 1, 0}, {-1e6, 0, 1});
    const auto tree = buildTree(mesh.view());
    test::Random random(76);
    for (int i = 0; i < 1000; ++i) {
      const auto [a, b, c] = mesh.view().corners(random.below(faceCount));
      const Vec3d target = random.chance(0.5) ? a : a + (b - a) * random.unit();
      const Vec3d origin = offset + random.direction() * (random.unit() * 1e-4);
      ASSERT_TRUE(tree.findIntersection({origin, target - origin})) << closed.name;
    }
  }
}

TEST(WideFormOfDoubles, IsRightWhenDenormalsAreFlushed) {
  const test::FlushToZero mode(true);
  const Mesh small = test::detail::scaled(test::detail::soup<double>(77, 100, 0.2), 0x1p-30);
  EXPECT_GT(compareAll(small, raysAtFaces(small, 0x1p-30, 300, 78)), 0u);
  Mesh flat = test::detail::soup<double>(79, 100, 0.2);
  for (Vec3d& position : flat.positions)
    position.x *= 1e-40;  // denormal as a float
  EXPECT_GT(compareAll(flat, raysAtFaces(flat, 1.0, 300, 80)), 0u);
}

TEST(WideFormOfDoubles, TheIntervalMayLieBeyondTheRangeOfFloat) {
  const auto tree = buildTree(test::detail::soup<double>(81, 100, 0.3));
  std::vector<Rayd> rays;
  for (const double limit : {1e300, -1e300, 1e-300, -1e-300}) {
    for (Rayd ray : test::hardRays(Mesh{}, tree.bounds(), 50, 82)) {
      (limit > 0.0 ? ray.tMax : ray.tMin) = limit;
      rays.push_back(ray);
      (limit > 0.0 ? ray.tMin : ray.tMax) = limit;
      rays.push_back(ray);
    }
  }
  EXPECT_GT(compareForms(tree.view(), rays), 0u);
}

}  // namespace
}  // namespace planetree::detail
