#include <planetree/build_tree.hpp>
#include <planetree/node/validate_tree.hpp>
#include <planetree/shape/sphere.hpp>

#include "unit/split/random_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace planetree {
namespace {

using test::MeshGenerator;

constexpr std::uint32_t kSeed = 16'180;

BuildOptions manySplits() {
  BuildOptions options;
  options.cost.faceCost = 1.0;
  return options;
}

/// All objects below a node, each once.
template <class O>
std::vector<std::uint32_t> objectsBelow(const KdTree<O>& tree, const Node& node) {
  std::vector<std::uint32_t> objects;
  if (node.isLeaf()) {
    const auto references = tree.references(node.leaf());
    objects.assign(references.begin(), references.end());
  } else {
    for (const Node* child : {&node.split().left(), &node.split().right()}) {
      const auto below = objectsBelow(tree, *child);
      objects.insert(objects.end(), below.begin(), below.end());
    }
  }
  std::sort(objects.begin(), objects.end());
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  return objects;
}

/// Where a split is left, it is the same; where it is gone, its objects are there, each once.
template <class O>
void expectRetracted(const KdTree<O>& before, const Node& was, const KdTree<O>& after,
                     const Node& is) {
  if (is.isLeaf()) {
    const auto references = after.references(is.leaf());
    EXPECT_EQ(std::vector(references.begin(), references.end()), objectsBelow(before, was));
    return;
  }
  ASSERT_FALSE(was.isLeaf());
  EXPECT_EQ(was.split().axis(), is.split().axis());
  EXPECT_EQ(was.split().position(), is.split().position());
  expectRetracted(before, was.split().left(), after, is.split().left());
  expectRetracted(before, was.split().right(), after, is.split().right());
}

TEST(RetractSplits, MakesLeavesOfTheirObjects) {
  MeshGenerator generator(kSeed);
  const auto mesh = generator.soupOfAnyCoordinates<float>(4000, 0.1f);
  BuildOptions options = manySplits();
  const auto before = buildTree(mesh.view(), options);
  options.retractsSplits = true;
  const auto after = buildTree(mesh.view(), options);
  EXPECT_LT(after.nodes().size(), before.nodes().size() / 2);
  EXPECT_GT(after.nodes().size(), 1u);
  EXPECT_LT(after.view().references.size(), before.view().references.size());
  EXPECT_EQ(after.report().referenceCount, after.view().references.size());
  EXPECT_FALSE(
      validateTree(after.nodes(), after.view().references, after.bounds(), after.objectCount()));
  expectRetracted(before, before.root(), after, after.root());
}

TEST(RetractSplits, IsTheSameForAnyNumberOfThreads) {
  MeshGenerator generator(kSeed + 1);
  const auto mesh = generator.soupOfAnyCoordinates<float>(40'000, 0.02f);
  BuildOptions options = BuildOptions::high();
  options.threadCount = 1;
  const auto one = buildTree(mesh.view(), options);
  for (const std::uint32_t threadCount : {2u, 3u, 8u}) {
    options.threadCount = threadCount;
    const auto many = buildTree(mesh.view(), options);
    ASSERT_EQ(one.nodes().size(), many.nodes().size());
    const auto words = [](const auto& tree) { return std::as_bytes(tree.nodes()); };
    EXPECT_TRUE(std::ranges::equal(words(one), words(many)));
    EXPECT_TRUE(std::ranges::equal(one.view().references, many.view().references));
  }
}

TEST(RetractSplits, LeavesTreesOfShapesAlone) {
  std::vector<Sphere<float>> balls;
  for (int i = 0; i < 500; ++i) {
    const auto x = static_cast<float>(i % 10);
    const auto y = static_cast<float>(i / 10 % 10);
    balls.push_back({{x, y, static_cast<float>(i / 100)}, 0.4f});
  }
  BuildOptions options;
  const auto before = buildTree(balls, options);
  options.retractsSplits = true;
  EXPECT_EQ(buildTree(balls, options).nodes().size(), before.nodes().size());
}

}  // namespace
}  // namespace planetree
