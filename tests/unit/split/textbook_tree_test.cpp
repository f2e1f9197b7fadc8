#include <planetree/build_tree.hpp>

#include "support/textbook_oracle.hpp"
#include "unit/split/random_meshes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace planetree {
namespace {

using test::MeshGenerator;
using test::TextbookNode;

constexpr std::uint32_t kSeed = 31'415;

/// Faces as the taught algorithm sees them: a box, and on which side of a plane the normal puts
/// them. Faces with two equal corners are no objects.
template <class T>
std::vector<Reference> textbookObjects(const TriangleMesh<T>& mesh) {
  std::vector<Reference> objects;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    const std::array<Vec3<T>, 3> corners = mesh.view().corners(face);
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
      continue;
    Reference object;
    object.object = face;
    for (const Vec3<T>& corner : corners)
      object.bounds.extend(corner);
    // Component i of the cross product is made of the two axes behind it in this cycle.
    constexpr std::array<Axis, 5> kCycle = {Axis::X, Axis::Y, Axis::Z, Axis::X, Axis::Y};
    const auto edge = [&](std::size_t to, Axis axis) {
      return static_cast<long double>(corners[to][axis]) -
             static_cast<long double>(corners[0][axis]);
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const long double normal = edge(1, kCycle[i + 1]) * edge(2, kCycle[i + 2]) -
                                 edge(1, kCycle[i + 2]) * edge(2, kCycle[i + 1]);
      if (normal < 0.0L)
        object.leftSides |= 1u << i;
    }
    objects.push_back(object);
  }
  return objects;
}

Box3 boundsOf(const std::vector<Reference>& objects) {
  Box3 bounds;
  for (const Reference& object : objects)
    bounds.extend(object.bounds);
  return bounds;
}

template <class O>
void expectSameTree(const KdTree<O>& tree, const Node& node, const TextbookNode& wanted) {
  ASSERT_EQ(node.isLeaf(), wanted.isLeaf());
  if (node.isLeaf()) {
    const auto objects = tree.references(node.leaf());
    EXPECT_EQ(std::vector(objects.begin(), objects.end()), wanted.objects);
    return;
  }
  EXPECT_EQ(node.split().axis(), wanted.axis);
  EXPECT_EQ(node.split().position(), wanted.position);
  if (testing::Test::HasFailure())
    return;
  expectSameTree(tree, node.split().left(), *wanted.left);
  expectSameTree(tree, node.split().right(), *wanted.right);
}

template <class T>
void expectTextbookTree(const TriangleMesh<T>& mesh, const BuildOptions& options) {
  const std::vector<Reference> objects = textbookObjects(mesh);
  const auto wanted = test::buildTextbookTree(objects, boundsOf(objects), 0, options);
  const auto tree = buildTree(mesh.view(), options);
  EXPECT_EQ(tree.bounds(), boundsOf(objects));
  expectSameTree(tree, tree.root(), *wanted);
}

/// The textbook's rules, and some with other limits so that trees grow deep.
std::vector<BuildOptions> textbookOptions() {
  std::vector<BuildOptions> all = {BuildOptions::textbook()};
  for (const std::uint32_t leafSize : {0u, 1u, 4u}) {
    for (const std::uint32_t depthLimit : {1u, 2u, 5u, 10u}) {
      BuildOptions options = BuildOptions::textbook();
      options.leafSize = leafSize;
      options.depthLimit = depthLimit;
      all.push_back(options);
    }
  }
  return all;
}

TEST(TextbookTree, IsThatOfTheOracleOnSoups) {
  MeshGenerator generator(kSeed);
  for (int round = 0; round < 6; ++round) {
    for (const BuildOptions& options : textbookOptions()) {
      SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", round " << round << ", leaf size "
                                      << options.leafSize << ", limit " << *options.depthLimit);
      expectTextbookTree(generator.soupOfAnyCoordinates<float>(60, 0.3f), options);
      expectTextbookTree(generator.soupOfAnyCoordinates<double>(60, 0.3), options);
      expectTextbookTree(generator.soupOfAnyCoordinates<float>(60, 0.02f), options);
      if (HasFailure())
        return;
    }
  }
}

TEST(TextbookTree, IsThatOfTheOracleOnIntegerSoups) {
  MeshGenerator generator(kSeed + 1);
  for (int round = 0; round < 6; ++round) {
    for (const BuildOptions& options : textbookOptions()) {
      SCOPED_TRACE(testing::Message()
                   << "seed " << kSeed + 1 << ", round " << round << ", leaf size "
                   << options.leafSize << ", limit " << *options.depthLimit);
      expectTextbookTree(generator.integerSoup<float>(60, 8, 2), options);
      expectTextbookTree(generator.slivers<float>(60, 12), options);
      if (HasFailure())
        return;
    }
  }
}

TEST(TextbookTree, IsThatOfTheOracleOnAxisAlignedGrids) {
  MeshGenerator generator(kSeed + 2);
  for (int round = 0; round < 6; ++round) {
    for (const BuildOptions& options : textbookOptions()) {
      SCOPED_TRACE(testing::Message()
                   << "seed " << kSeed + 2 << ", round " << round << ", leaf size "
                   << options.leafSize << ", limit " << *options.depthLimit);
      expectTextbookTree(generator.axisAlignedGrid<float>(40, 4), options);
      expectTextbookTree(generator.coplanarSoup<float>(40, 9, Axis::Y, 3), options);
      if (HasFailure())
        return;
    }
  }
}

TEST(TextbookTree, DividesSoupsAtAll) {
  MeshGenerator generator(kSeed + 3);
  BuildOptions options = BuildOptions::textbook();
  options.leafSize = 1;
  const auto tree = buildTree(generator.soupOfAnyCoordinates<float>(60, 0.02f), options);
  EXPECT_GT(tree.statistics().splitNodeCount, 10u);
}

TEST(TextbookTree, EndsWhereCuttingOffEmptySpaceIsCheapest) {
  // Two clusters far apart. The root is cut at the end of the first; what is then cheapest for the
  // second is to cut off the space before it, which leaves one side empty.
  TriangleMesh<float> mesh;
  for (int i = 0; i < 50; ++i) {
    const float shift = static_cast<float>(i) / 64.0f;
    test::addFace<float>(mesh, {{{shift, 0, 0}, {shift + 0.1f, 1, 0}, {shift, 0, 1}}});
    test::addFace<float>(mesh, {{{9 + shift, 0, 0}, {9.1f + shift, 1, 0}, {9 + shift, 0, 1}}});
  }
  const auto textbook = buildTree(mesh.view(), BuildOptions::textbook());
  BuildOptions options;
  options.cost.faceCost = 1.0;
  const auto mended = buildTree(mesh.view(), options);
  EXPECT_GE(textbook.statistics().largestLeaf, 50u);
  EXPECT_GT(textbook.statistics().largestLeaf, textbook.options().leafSize);
  EXPECT_LT(mended.statistics().largestLeaf, 20u);
}

TEST(TextbookTree, CanBeOneLeafForWhatTheDefaultsDivide) {
  // Many faces in one plane, whose normals put them on the dear side of it, amid others that reach
  // from end to end. The walls of the cell then are the cheapest planes, and one side is empty.
  TriangleMesh<float> mesh;
  for (int i = 0; i < 600; ++i)
    test::addFace<float>(mesh, {{{0, 0, 0}, {10, 1, 0}, {5, 0.5f, 1}}});
  for (int i = 0; i < 100; ++i)
    test::addFace<float>(mesh, {{{2, 0, 0}, {2, 1, 0}, {2, 1, 1}}});
  const auto textbook = buildTree(mesh.view(), BuildOptions::textbook());
  const auto mended = buildTree(mesh.view());
  ASSERT_EQ(textbook.nodes().size(), 1u);
  EXPECT_EQ(textbook.root().leaf().count(), 700u);
  EXPECT_GT(mended.statistics().splitNodeCount, 0u);
}

}  // namespace
}  // namespace planetree
