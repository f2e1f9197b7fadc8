#include <planetree/planetree.hpp>

#include "support/closed_meshes.hpp"
#include "support/flush_to_zero.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace planetree::test {
namespace {

/// Rays from inside a closed mesh at its vertices, along its edges, across them, and along the
/// axes.
template <class T>
Ray<T> aimedRay(const ClosedMesh<T>& closed, Random& random) {
  const TriangleMesh<T>& mesh = closed.mesh;
  const FaceIndices& face = mesh.faces[random.below(mesh.faces.size())];
  const Vec3<T> a = mesh.positions[face[0]];
  const Vec3<T> b = mesh.positions[face[1]];
  const Vec3<T> origin =
      closed.center + static_cast<Vec3<T>>(random.direction() * random.unit()) * closed.innerRadius;
  switch (random.below(5)) {
    case 0:
      return {origin, a - origin};
    case 1:
      return {closed.center, a - closed.center};
    case 2:
      return {origin, (a + b) * T(0.5) - origin};
    case 3:
      return {origin, a + (b - a) * static_cast<T>(random.unit()) - origin};
    default: {
      // Along an axis, at a height that many vertices share.
      Vec3<T> from = closed.center;
      const std::size_t axis = random.below(3);
      from[kAxes[(axis + 1) % 3]] = origin[kAxes[(axis + 1) % 3]];
      Vec3<T> direction{T(0), T(-0.0), T(0)};
      direction[kAxes[axis]] = random.chance(0.5) ? T(1) : T(-1);
      return {from, direction};
    }
  }
}

template <class T>
class Leak : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Leak, Scalars);

template <class T>
std::uint64_t countLeaks(std::uint64_t raysPerMesh) {
  std::uint64_t leaks = 0;
  Random random(31);
  for (const ClosedMesh<T>& closed : closedMeshes<T>()) {
    const KdTree<Face<T>> tree = buildTree(closed.mesh.view());
    std::uint64_t leaksHere = 0;
    for (std::uint64_t i = 0; i < raysPerMesh; ++i) {
      const Ray<T> ray = aimedRay(closed, random);
      if (!tree.findIntersection(ray))
        ++leaksHere;
      if (!tree.isOccluded(ray))
        ++leaksHere;
    }
    EXPECT_EQ(leaksHere, 0u) << closed.name << ", " << describeSeed();
    leaks += leaksHere;
  }
  return leaks;
}

// One million rays in all for each precision.
TYPED_TEST(Leak, NoRayLeavesAClosedMesh) {
  EXPECT_EQ(countLeaks<TypeParam>(125'000), 0u);
}

TYPED_TEST(Leak, NoRayLeavesAClosedMeshWhenDenormalsAreFlushed) {
  const FlushToZero mode(true);
  EXPECT_EQ(countLeaks<TypeParam>(25'000), 0u);
}

}  // namespace
}  // namespace planetree::test
