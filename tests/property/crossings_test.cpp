#include <planetree/planetree.hpp>

#include "support/closed_meshes.hpp"
#include "support/flush_to_zero.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace planetree::test {
namespace {

template <class T>
class Crossings : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Crossings, Scalars);

constexpr QueryOptions kCrossings{.crossings = true};

/// Hits from behind less hits from the front.
template <class T>
int sumOfSides(const KdTree<Face<T>>& tree, const Ray<T>& ray) {
  std::array<Hit<T>, 16> hits;
  int sum = 0;
  FoundHits found = tree.findIntersections(ray, hits, kCrossings);
  while (true) {
    for (std::size_t i = 0; i < found.count; ++i)
      sum += dot(hits[i].normal, ray.direction) > T(0) ? 1 : -1;
    if (!found.hasMore)
      return sum;
    found = tree.findNextIntersections(ray, hits.back(), hits, kCrossings);
  }
}

template <class T>
Ray<T> wholeLine(const Vec3<T>& through, const Vec3<T>& direction) {
  return {through, direction, -std::numeric_limits<T>::infinity()};
}

template <class T>
Vec3<T> axisDirection(Random& random) {
  Vec3<T> direction{T(0), random.chance(0.5) ? T(0) : T(-0.0), T(0)};
  direction[kAxes[random.below(3)]] = random.chance(0.5) ? T(1) : T(-1);
  return direction;
}

/// A line that meets the mesh at a vertex, along an edge, in the plane of a face, or anyhow.
template <class T>
Ray<T> hardLine(const TriangleMesh<T>& mesh, Random& random) {
  const auto& [first, second, third] = mesh.faces[random.below(mesh.faces.size())];
  const Vec3<T> a = mesh.positions[first];
  const Vec3<T> b = mesh.positions[second];
  const Vec3<T> c = mesh.positions[third];
  const Vec3<T> other = mesh.positions[random.below(mesh.positions.size())];
  const auto part = static_cast<T>(random.unit());
  switch (random.below(7)) {
    case 0:  // vertex to vertex
      return wholeLine(a, other - a);
    case 1:
      return wholeLine(a, static_cast<Vec3<T>>(random.direction()));
    case 2:  // along an edge
      return wholeLine(a, b - a);
    case 3:  // through an edge
      return wholeLine(a + (b - a) * part, other - (a + (b - a) * part));
    case 4:  // in the plane of a face
      return wholeLine(a + (b - a) * part, c - (a + (b - a) * part));
    case 5:  // where edges of grids lie
      return wholeLine(random.chance(0.5) ? a : a + (b - a) * part, axisDirection<T>(random));
    default:
      return wholeLine((a + b + c) / T(3), static_cast<Vec3<T>>(random.direction()));
  }
}

template <class T>
void expectNoLineEndsInside(std::uint64_t linesPerMesh) {
  Random random(41);
  for (const ClosedMesh<T>& closed : closedMeshes<T>()) {
    const KdTree<Face<T>> tree = buildTree(closed.mesh.view());
    std::uint64_t wrongCount = 0;
    for (std::uint64_t i = 0; i < linesPerMesh; ++i)
      wrongCount += sumOfSides(tree, hardLine(closed.mesh, random)) != 0 ? 1u : 0u;
    EXPECT_EQ(wrongCount, 0u) << closed.name << ", " << describeSeed();
  }
}

TYPED_TEST(Crossings, AreEquallyManyFromBothSidesOverAClosedMesh) {
  expectNoLineEndsInside<TypeParam>(40'000);
}

TYPED_TEST(Crossings, AreEquallyManyFromBothSidesWhenDenormalsAreFlushed) {
  const FlushToZero mode(true);
  expectNoLineEndsInside<TypeParam>(5'000);
}

/// Closed, and as badly behaved as can be: tetrahedra between the points of a small grid. They cut
/// through each other, share corners and parts of edges and faces, lie in planes, and some are
/// flat or inside out.
template <class T>
TriangleMesh<T> tangledTetrahedra(Random& random, int count, T scale) {
  constexpr std::size_t kSide = 4;
  TriangleMesh<T> mesh;
  for (std::size_t i = 0; i < kSide * kSide * kSide; ++i) {
    mesh.positions.push_back(Vec3<T>{static_cast<T>(i % kSide), static_cast<T>(i / kSide % kSide),
                                     static_cast<T>(i / kSide / kSide)} *
                             scale);
  }
  const auto vertex = [&] {
    return static_cast<std::uint32_t>(random.below(mesh.positions.size()));
  };
  for (int i = 0; i < count; ++i) {
    const std::uint32_t a = vertex();
    const std::uint32_t b = vertex();
    const std::uint32_t c = vertex();
    const std::uint32_t d = vertex();
    mesh.faces.insert(mesh.faces.end(), {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}});
  }
  return mesh;
}

TYPED_TEST(Crossings, AreEquallyManyFromBothSidesOfTetrahedraThatShareAlmostEverything) {
  using T = TypeParam;
  Random random(42);
  for (const T scale : {T(1), T(0x1p-30), T(0x1p28), T(1) / T(3)}) {
    for (int round = 0; round < 20; ++round) {
      const TriangleMesh<T> mesh = tangledTetrahedra(random, 25, scale);
      const KdTree<Face<T>> tree = buildTree(mesh.view());
      for (int i = 0; i < 1'000; ++i) {
        const Ray<T> line = hardLine(mesh, random);
        ASSERT_EQ(sumOfSides(tree, line), 0) << "scale " << scale << ", " << describeSeed();
      }
    }
  }
}

TYPED_TEST(Crossings, TellInsideFromOutsideAlsoThroughEdgesAndVertices) {
  using T = TypeParam;
  Random random(43);
  for (const ClosedMesh<T>& closed : closedMeshes<T>()) {
    const KdTree<Face<T>> tree = buildTree(closed.mesh.view());
    const Vec3d size =
        static_cast<Vec3d>(tree.bounds().upper) - static_cast<Vec3d>(tree.bounds().lower);
    for (int i = 0; i < 4'000; ++i) {
      const bool isInside = random.chance(0.5);
      const Vec3<T> offset =
          isInside ? static_cast<Vec3<T>>(random.direction() * random.unit()) * closed.innerRadius
                   : static_cast<Vec3<T>>(random.direction() * (length(size) * 2.0));
      const Vec3<T> origin = closed.center + offset;
      const Vec3<T> target = hardLine(closed.mesh, random).origin;
      const Vec3<T> direction = random.chance(0.2) ? axisDirection<T>(random) : target - origin;
      ASSERT_EQ(sumOfSides(tree, {origin, direction}), isInside ? 1 : 0)
          << closed.name << ", " << describeSeed();
    }
  }
}

TYPED_TEST(Crossings, OfASharedEdgeOrVertexHitJustOneFaceOnTheWayThrough) {
  using T = TypeParam;
  // A pyramid over the square from -1 to 1, seen from above: four faces meet at the apex.
  const TriangleMesh<T> pyramid{
      .positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}},
      .faces = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
      .sourceFaces = {}};
  const KdTree<Face<T>> tree = buildTree(pyramid.view());
  std::array<Hit<T>, 8> hits;
  for (const Vec3<T>& above :
       {Vec3<T>{0, 0, 5}, Vec3<T>{T(0.5), T(0.5), 5}, Vec3<T>{T(-0.25), T(0.25), 5}}) {
    const Ray<T> ray{above, {0, 0, -1}};
    EXPECT_GT(tree.findIntersections(ray, hits).count, 1u);
    EXPECT_EQ(tree.findIntersections(ray, hits, kCrossings).count, 1u);
    EXPECT_TRUE(tree.isOccluded(ray, kCrossings));
    const QueryOptions fromBehind{.cullsBackFaces = true, .crossings = true};
    EXPECT_TRUE(tree.isOccluded(ray, fromBehind));
    EXPECT_FALSE(tree.isOccluded({{above.x, above.y, -5}, {0, 0, 1}}, fromBehind));
  }
}

TYPED_TEST(Crossings, ChangeNothingForShapesWithoutEdgesToShare) {
  using T = TypeParam;
  const auto tree = buildTree(std::vector<Box<T>>{{}, {{T(0.5), T(-0.5), T(-0.5)}, {1, 1, 1}}});
  for (const T y : {T(-0.5), T(0), T(0.5)}) {
    const Ray<T> ray{{T(0.5), y, 5}, {0, 0, -1}};
    std::array<Hit<T>, 8> plain;
    std::array<Hit<T>, 8> crossing;
    EXPECT_EQ(tree.findIntersections(ray, plain),
              tree.findIntersections(ray, crossing, kCrossings));
    EXPECT_EQ(plain, crossing);
  }
}

}  // namespace
}  // namespace planetree::test
