#include <planetree/build_tree.hpp>
#include <planetree/node/validate_tree.hpp>
#include <planetree/scene.hpp>

#include "../../../src/node/wide_node.hpp"
#include "unit/split/random_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace planetree {
namespace {

using test::MeshGenerator;

constexpr std::uint32_t kSeed = 141'421;
// Large enough for cells that all threads divide together, and for subtrees at several levels
// below.
constexpr int kLargeFaceCount = 90'000;

template <class Word>
void expectSameBytes(std::span<const Word> a, std::span<const Word> b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0);
}

template <class O>
void expectSameTree(const KdTree<O>& a, const KdTree<O>& b) {
  expectSameBytes(a.nodes(), b.nodes());
  expectSameBytes(a.view().references, b.view().references);
  EXPECT_EQ(a.bounds(), b.bounds());
  expectSameBytes(a.view().wide->nodes, b.view().wide->nodes);
  expectSameBytes(a.view().wide->blocks, b.view().wide->blocks);
}

template <class T>
void expectSameTreeForAllThreadCounts(TriangleMeshView<T> mesh, BuildOptions options) {
  options.threadCount = 1;
  const auto serial = buildTree(mesh, options);
  EXPECT_GT(serial.nodes().size(), 1u);
  EXPECT_FALSE(validateTree(serial.nodes(), serial.view().references, serial.bounds(),
                            serial.objectCount()));
  for (const std::uint32_t threadCount : {1u, 2u, 3u, 8u, 0u}) {
    options.threadCount = threadCount;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", " << threadCount << " threads");
    expectSameTree(serial, buildTree(mesh, options));
  }
}

TEST(Determinism, HoldsForAllThreadCountsOnALargeSoup) {
  MeshGenerator generator(kSeed);
  const auto mesh = generator.soupOfAnyCoordinates<float>(kLargeFaceCount, 0.01f);
  expectSameTreeForAllThreadCounts(mesh.view(), {});
}

TEST(Determinism, HoldsForAllThreadCountsOnALargeGridWithManyTies) {
  MeshGenerator generator(kSeed);
  const auto mesh = generator.axisAlignedGrid<float>(kLargeFaceCount / 2, 24);
  expectSameTreeForAllThreadCounts(mesh.view(), {});
}

TEST(Determinism, HoldsForAllThreadCountsWithWholeBoxes) {
  MeshGenerator generator(kSeed);
  const auto mesh = generator.soupOfAnyCoordinates<double>(kLargeFaceCount, 0.01);
  expectSameTreeForAllThreadCounts(mesh.view(), BuildOptions::textbook());
}

TEST(Determinism, HoldsForScenesOfSeveralGeometries) {
  MeshGenerator generator(kSeed);
  const auto first = generator.soupOfAnyCoordinates<float>(5000, 0.02f);
  const auto second = generator.integerSoup<float>(5000, 2, 1);
  Scene<float> scene;
  scene.add(first.view());
  scene.add(second.view());
  scene.add(first.view());
  BuildOptions options;
  options.threadCount = 1;
  const auto serial = buildTree(scene, options);
  options.threadCount = 8;
  expectSameTree(serial, buildTree(scene, options));
}

TEST(Determinism, HoldsForOwnedAndViewedMeshes) {
  MeshGenerator generator(kSeed);
  const auto mesh = generator.soupOfAnyCoordinates<float>(3000, 0.05f);
  expectSameTree(buildTree(mesh.view()), buildTree(mesh));
}

TEST(Determinism, HoldsForOneMeshDividedIntoGeometries) {
  MeshGenerator generator(kSeed);
  TriangleMesh<float> whole;
  Scene<float> scene;
  for (const int faceCount : {1, 3000, 0, 2000, 1}) {
    const auto part = generator.soupOfAnyCoordinates<float>(faceCount, 0.1f);
    for (std::uint32_t face = 0; face < part.faces.size(); ++face)
      test::addFace(whole, part.view().corners(face));
    scene.add(part);
  }
  const auto wholeTree = buildTree(whole.view());
  const auto sceneTree = buildTree(scene);
  expectSameBytes(wholeTree.nodes(), sceneTree.nodes());
  expectSameBytes(wholeTree.view().references, sceneTree.view().references);
}

// Powers of two scale all boxes, areas and margins without rounding, and leave costs alone.
TEST(Determinism, ScalesTheTreeWithTheMesh) {
  MeshGenerator generator(kSeed);
  for (const BuildOptions& options : {BuildOptions{}, BuildOptions::textbook()}) {
    const auto mesh = generator.soupOfAnyCoordinates<float>(1000, 0.2f);
    const auto tree = buildTree(mesh.view(), options);
    for (const int exponent : {-60, -1, 20, 60}) {
      TriangleMesh<float> scaled = mesh;
      for (Vec3f& position : scaled.positions)
        position = position * std::ldexp(1.0f, exponent);
      const auto scaledTree = buildTree(scaled.view(), options);
      std::vector<Node> nodes;
      for (const Node& node : tree.nodes()) {
        nodes.push_back(node);
        if (!node.isLeaf()) {
          const SplitNode& split = node.split();
          nodes.back() =
              SplitNode(split.axis(), std::ldexp(split.position(), exponent), split.rightOffset());
        }
      }
      SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", 2^" << exponent);
      expectSameBytes<Node>(nodes, scaledTree.nodes());
      expectSameBytes(tree.view().references, scaledTree.view().references);
    }
  }
}

/// The planes of a tree from left to right, and how many objects each leaf has.
template <class O>
std::vector<Node> nodesWithoutReferenceOffsets(const KdTree<O>& tree) {
  std::vector<Node> nodes;
  for (const Node& node : tree.nodes())
    nodes.push_back(node.isLeaf() ? Node(LeafNode(0, node.leaf().count())) : node);
  return nodes;
}

TEST(Determinism, LeavesThePlanesAloneWhenFacesAreReordered) {
  for (std::uint32_t seed = kSeed; seed < kSeed + 10; ++seed) {
    MeshGenerator generator(seed);
    for (const BuildOptions& options : {BuildOptions{}, BuildOptions::textbook()}) {
      const auto mesh = generator.axisAlignedGrid<float>(300, 6);
      TriangleMesh<float> reversed = mesh;
      std::reverse(reversed.faces.begin(), reversed.faces.end());
      const auto tree = buildTree(mesh.view(), options);
      const auto other = buildTree(reversed.view(), options);
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      expectSameBytes<Node>(nodesWithoutReferenceOffsets(tree),
                            nodesWithoutReferenceOffsets(other));
      const auto last = static_cast<std::uint32_t>(mesh.faces.size() - 1);
      for (std::size_t i = 0; i < tree.nodes().size(); ++i) {
        if (!tree.nodes()[i].isLeaf())
          continue;
        std::vector<std::uint32_t> mirrored;
        for (const std::uint32_t face : other.references(other.nodes()[i].leaf()))
          mirrored.insert(mirrored.begin(), last - face);
        const auto faces = tree.references(tree.nodes()[i].leaf());
        EXPECT_EQ(std::vector(faces.begin(), faces.end()), mirrored);
      }
    }
  }
}

}  // namespace
}  // namespace planetree
