#include "soak/closed_solids.hpp"

#include <planetree/planetree.hpp>

#include "soak/leak_counts.hpp"
#include "soak/solid_rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace planetree::test {
namespace {

template <class T>
class ClosedSolids : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ClosedSolids, Scalars);

TYPED_TEST(ClosedSolids, HaveTwoFacesAtEachEdgeThatRunOppositeWays) {
  for (const Solid& solid : closedSolids()) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const FaceIndices& face : solid.mesh.faces) {
      for (std::size_t i = 0; i < 3; ++i)
        ++edges[{face[i], face[(i + 1) % 3]}];
    }
    for (const auto& [edge, count] : edges) {
      const auto reverse = edges.find({edge.second, edge.first});
      ASSERT_EQ(count, 1) << solid.name;
      ASSERT_TRUE(reverse != edges.end()) << solid.name;
    }
    EXPECT_EQ(solid.coreOfFace.size(), solid.mesh.faces.size()) << solid.name;
    EXPECT_GT(solid.clearance, 0.0) << solid.name;
  }
}

TYPED_TEST(ClosedSolids, CoverTheDocumentedRange) {
  using T = TypeParam;
  double leastExtent = 1.0;
  double mostExtent = 1.0;
  double farthest = 0.0;
  std::set<std::string> names;
  for (const PlacedSolid<T>& solid : placedSolids<T>()) {
    leastExtent = std::min(leastExtent, solid.extent);
    mostExtent = std::max(mostExtent, solid.extent);
    for (const Vec3<T>& position : solid.mesh.positions)
      farthest = std::max(farthest, static_cast<double>(std::fabs(position.x)));
    if (solid.placement == "unit")
      names.insert(solid.name);
  }
  EXPECT_EQ(names.size(), closedSolids().size());
  EXPECT_LT(leastExtent, 0x1.1p-30);
  EXPECT_GT(mostExtent, 0x1p29);
  EXPECT_GT(farthest, 0x1p29);
  EXPECT_LE(farthest, 0x1p30);
}

TYPED_TEST(ClosedSolids, HaveEveryVertexEdgeAndFaceAimedAt) {
  using T = TypeParam;
  const std::vector<PlacedSolid<T>> solids = placedSolids<T>();
  const PlacedSolid<T>& solid = solids.front();
  std::set<std::pair<std::size_t, std::size_t>> vertices;
  std::set<std::size_t> faces;
  std::vector<Ray<T>> rays(3 * solid.mesh.faces.size());
  // A ray is aimed at a vertex if its direction is the rounded difference.
  for (std::uint64_t block = 0; block < 25; ++block) {
    fillWithInnerRays<T>(solid, 1, block, rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const FaceIndices& face = solid.mesh.faces[i / 3];
      const Vec3<T> a = solid.mesh.positions[face[i % 3]];
      if (rays[i].direction == a - rays[i].origin)
        vertices.insert({i / 3, i % 3});
      const auto c = static_cast<Vec3d>(a) +
                     static_cast<Vec3d>(solid.mesh.positions[face[(i + 1) % 3]]) +
                     static_cast<Vec3d>(solid.mesh.positions[face[(i + 2) % 3]]);
      if (rays[i].direction == static_cast<Vec3<T>>(c / 3.0) - rays[i].origin)
        faces.insert(i / 3);
    }
  }
  EXPECT_EQ(vertices.size(), rays.size());
  EXPECT_EQ(faces.size(), solid.mesh.faces.size());
}

template <class T>
LeakCounts soaked(const KdTree<Face<T>>& tree, const PlacedSolid<T>& solid) {
  LeakCounts counts;
  LeakCounter<T> counter(tree);
  // A block of each kind, with all targets.
  std::vector<Ray<T>> rays(3 * solid.mesh.faces.size());
  for (std::uint64_t block = 0; block < 5; ++block) {
    fillWithInnerRays<T>(solid, 1, block, rays);
    counter.askInside(rays, counts);
    fillWithOuterRays<T>(solid, 1, block, rays);
    counter.askOutside(rays, counts);
  }
  return counts;
}

// The count is worth something only if it is not always zero.
TYPED_TEST(ClosedSolids, LeakWhereAFaceIsMissing) {
  using T = TypeParam;
  for (const PlacedSolid<T>& solid : placedSolids<T>()) {
    // Not the large ones: every face of the others is aimed at.
    if (solid.placement != "unit" || solid.mesh.faces.size() > 1100)
      continue;
    EXPECT_EQ(soaked(buildTree(solid.mesh.view()), solid).leaks(), 0u) << solid.name;
    TriangleMesh<T> open = solid.mesh;
    // A large one: many of the sliver box are too small to be met by chance.
    const auto area = [&](const FaceIndices& face) {
      const auto at = [&](std::size_t i) { return static_cast<Vec3d>(open.positions[face[i]]); };
      return length(cross(at(1) - at(0), at(2) - at(0)));
    };
    open.faces.erase(std::max_element(
        open.faces.begin(), open.faces.end(),
        [&](const FaceIndices& a, const FaceIndices& b) { return area(a) < area(b); }));
    const LeakCounts counts = soaked(buildTree(open.view()), solid);
    EXPECT_GT(counts.nearest, 0u) << solid.name;
    EXPECT_EQ(counts.any, counts.nearest) << solid.name;
    EXPECT_EQ(counts.all, counts.nearest) << solid.name;
    EXPECT_EQ(counts.nearestOfBatch, counts.nearest) << solid.name;
    EXPECT_EQ(counts.anyOfBatch, counts.nearest) << solid.name;
    EXPECT_GT(counts.innerCrossings, 0u) << solid.name;
    EXPECT_GT(counts.outerCrossings, 0u) << solid.name;
  }
}

}  // namespace
}  // namespace planetree::test
