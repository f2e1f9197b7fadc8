#include <planetree/build_tree.hpp>
#include <planetree/detail/tree_data.hpp>
#include <planetree/node/tree_statistics.hpp>
#include <planetree/node/validate_tree.hpp>

#include "unit/split/random_meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

namespace planetree {
namespace {

constexpr std::uint32_t kSeed = 832'040;

/// The arrays of a tree that may hold anything.
struct Arrays {
  std::vector<Node> nodes;
  std::vector<std::uint32_t> references;
  Box3 bounds;
  std::uint64_t objectCount = 0;

  [[nodiscard]] bool areAccepted() const {
    return !validateTree(nodes, references, bounds, objectCount);
  }
};

/// The promises of `validateTree`, each read from its documentation and checked on its own.
class SlowCheck {
 public:
  explicit SlowCheck(const Arrays& arrays)
      : arrays_(arrays), visitCounts_(arrays.nodes.size(), 0) {}

  [[nodiscard]] bool holds() {
    if (!visit(0, arrays_.bounds, 1))
      return false;
    for (const int count : visitCounts_) {
      if (count != 1)
        return false;
    }
    return true;
  }

 private:
  bool visit(std::size_t index, Box3 cell, std::uint32_t level) {
    if (index >= arrays_.nodes.size() || level > kMaxTreeDepth || ++visitCounts_[index] > 1)
      return false;
    const Node& node = arrays_.nodes[index];
    if (node.isLeaf())
      return isSound(node.leaf());
    const SplitNode& split = node.split();
    const float position = split.position();
    if (!std::isfinite(position) || position < cell.lower[split.axis()] ||
        position > cell.upper[split.axis()])
      return false;
    Box3 left = cell;
    Box3 right = cell;
    left.upper[split.axis()] = position;
    right.lower[split.axis()] = position;
    return visit(index + 1, left, level + 1) &&
           visit(index + split.rightOffset(), right, level + 1);
  }

  [[nodiscard]] bool isSound(const LeafNode& leaf) const {
    for (std::uint64_t i = 0; i < leaf.count(); ++i) {
      const std::uint64_t place = leaf.firstReference() + i;
      if (place >= arrays_.references.size() || arrays_.references[place] >= arrays_.objectCount ||
          (i > 0 && arrays_.references[place] <= arrays_.references[place - 1]))
        return false;
    }
    return true;
  }

  const Arrays& arrays_;
  std::vector<int> visitCounts_;
};

class Spoiler {
 public:
  explicit Spoiler(std::uint32_t seed) : random_(seed) {}

  [[nodiscard]] std::uint32_t word() { return words_(random_); }
  [[nodiscard]] std::size_t below(std::size_t end) { return word() % end; }

  template <class Word>
  [[nodiscard]] std::vector<Word> randomWords(std::size_t count, const Word& filler) {
    std::vector<Word> made(count, filler);
    for (Word& one : made)
      overwrite(one);
    return made;
  }

  /// Flips a bit, changes a byte or a whole word, or cuts or lengthens an array.
  void spoil(Arrays& arrays) {
    switch (below(7)) {
      case 0:
        return flipBit(arrays.nodes[below(arrays.nodes.size())]);
      case 1:
        return overwrite(arrays.nodes[below(arrays.nodes.size())]);
      case 2:
        return arrays.nodes.resize(1 + below(arrays.nodes.size()), LeafNode(0, 0));
      case 3:
        return arrays.nodes.push_back(arrays.nodes[below(arrays.nodes.size())]);
      case 4:
        return arrays.references.resize(below(arrays.references.size() + 2));
      case 5:
        arrays.nodes[below(arrays.nodes.size())] = arrays.nodes[below(arrays.nodes.size())];
        return;
      default:
        if (!arrays.references.empty())
          flipBit(arrays.references[below(arrays.references.size())]);
    }
  }

 private:
  template <class Word>
  void flipBit(Word& target) {
    unsigned char bytes[sizeof(Word)];
    std::memcpy(bytes, &target, sizeof(bytes));
    unsigned char& byte = bytes[below(sizeof(bytes))];
    byte = static_cast<unsigned char>(byte ^ 1u << below(8));
    std::memcpy(static_cast<void*>(&target), bytes, sizeof(bytes));
  }

  template <class Word>
  void overwrite(Word& target) {
    std::uint32_t drawn[2] = {word(), word()};
    // Small links and offsets are the ones that come close to being valid.
    if (below(2) == 0)
      drawn[0] %= 64;
    if (below(2) == 0)
      drawn[1] %= 4;
    std::memcpy(static_cast<void*>(&target), drawn, sizeof(target));
  }

  std::mt19937 random_;
  std::uniform_int_distribution<std::uint32_t> words_;
};

void expectJudgedRight(const Arrays& arrays) {
  const bool isAccepted = arrays.areAccepted();
  // What is in depth-first order is stricter than what the slow check asks, so only one way.
  if (!isAccepted)
    return;
  EXPECT_TRUE(SlowCheck(arrays).holds());
  const TreeStatistics statistics =
      treeStatistics(arrays.nodes, arrays.bounds, {.traversalCost = 1.5, .intersectionCost = 1.0});
  EXPECT_EQ(statistics.splitNodeCount + statistics.leafNodeCount, arrays.nodes.size());
  EXPECT_LE(statistics.depth, kMaxTreeDepth);
}

TEST(ValidateTree, SurvivesRandomBytes) {
  Spoiler spoiler(kSeed);
  int acceptedCount = 0;
  for (int round = 0; round < 60'000; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", round " << round);
    Arrays arrays;
    arrays.nodes = spoiler.randomWords<Node>(1 + spoiler.below(12), LeafNode(0, 0));
    // Leaves that share out even one reference are rare among random ones.
    const std::size_t referenceCount = spoiler.below(2) == 0 ? 0 : spoiler.below(12);
    arrays.references = spoiler.randomWords<std::uint32_t>(referenceCount, 0u);
    arrays.bounds = {.lower = {-1, -1, -1}, .upper = {1, 1, 1}};
    arrays.objectCount = spoiler.below(64);
    acceptedCount += arrays.areAccepted() ? 1 : 0;
    expectJudgedRight(arrays);
    if (HasFailure())
      return;
  }
  EXPECT_GT(acceptedCount, 0);
}

TEST(ValidateTree, SurvivesRandomBounds) {
  Spoiler spoiler(kSeed + 1);
  const std::vector<Node> nodes = {SplitNode(Axis::X, 0.0f, 2), LeafNode(0, 0), LeafNode(0, 0)};
  for (int round = 0; round < 20'000; ++round) {
    Box3 bounds;
    for (const Axis axis : kAxes) {
      const std::uint32_t bits[2] = {spoiler.word(), spoiler.word()};
      std::memcpy(&bounds.lower[axis], &bits[0], sizeof(float));
      std::memcpy(&bounds.upper[axis], &bits[1], sizeof(float));
    }
    const bool isBox = isFinite(bounds.lower) && isFinite(bounds.upper) && !bounds.isEmpty();
    const bool holdsPlane = bounds.lower.x <= 0.0f && bounds.upper.x >= 0.0f;
    EXPECT_EQ(validateTree(nodes, {}, bounds, 0).has_value(), !(isBox && holdsPlane))
        << "seed " << kSeed + 1 << ", round " << round;
  }
}

// Whatever is accepted can be walked by rays.
TEST(ValidateTree, AcceptsNothingThatTraversalCannotWalk) {
  test::MeshGenerator generator(kSeed);
  const auto mesh = generator.soupOfAnyCoordinates<float>(60, 0.3f);
  BuildOptions options;
  options.leafSize = 1;
  const auto tree = buildTree(mesh.view(), options);
  Spoiler spoiler(kSeed + 2);
  int acceptedCount = 0;
  for (int round = 0; round < 30'000; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed + 2 << ", round " << round);
    Arrays arrays;
    arrays.nodes.assign(tree.nodes().begin(), tree.nodes().end());
    arrays.references.assign(tree.view().references.begin(), tree.view().references.end());
    arrays.bounds = tree.bounds();
    arrays.objectCount = tree.objectCount();
    const std::size_t damageCount = 1 + spoiler.below(3);
    for (std::size_t i = 0; i < damageCount; ++i)
      spoiler.spoil(arrays);
    arrays.nodes.shrink_to_fit();
    arrays.references.shrink_to_fit();
    expectJudgedRight(arrays);
    if (arrays.areAccepted()) {
      ++acceptedCount;
      const KdTree<Face<float>> spoilt(
          detail::TreeData<float>{.nodes = arrays.nodes,
                                  .references = arrays.references,
                                  .geometries = {detail::viewedEntry(mesh.view())},
                                  .bounds = arrays.bounds,
                                  .options = {},
                                  .report = {}});
      const float t = static_cast<float>(round % 16) / 16.0f;
      for (const Vec3f& direction : {Vec3f{1, 0, 0}, Vec3f{0.3f, 1, -0.5f}}) {
        static_cast<void>(spoilt.findIntersection(Rayf{{-1, t, t}, direction}));
        static_cast<void>(spoilt.isOccluded(Rayf{{t, -1, t}, direction}));
      }
    }
    if (HasFailure())
      return;
  }
  EXPECT_GT(acceptedCount, 100);
  EXPECT_LT(acceptedCount, 30'000);
}

}  // namespace
}  // namespace planetree
