#include <planetree/node/validate_tree.hpp>

#include <planetree/build_tree.hpp>

#include "unit/split/random_meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace planetree {
namespace {

constexpr Box3 kBounds = {.lower = {0, 0, 0}, .upper = {4, 4, 4}};
constexpr std::uint64_t kObjectCount = 4;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A tree to be spoilt: a split along x at 2, the left half split along y at 1.
struct HandMadeTree {
  std::vector<Node> nodes = {SplitNode(Axis::X, 2.0f, 4), SplitNode(Axis::Y, 1.0f, 2),
                             LeafNode(0, 2), LeafNode(2, 1), LeafNode(3, 3)};
  std::vector<std::uint32_t> references = {0, 1, 1, 1, 2, 3};

  [[nodiscard]] std::optional<std::string> problem() const {
    return validateTree(nodes, references, kBounds, kObjectCount);
  }
};

void expectProblem(const HandMadeTree& tree, std::size_t node, const std::string& words) {
  const auto problem = tree.problem();
  ASSERT_TRUE(problem) << "wanted: " << words;
  EXPECT_NE(problem->find("node " + std::to_string(node) + " "), std::string::npos) << *problem;
  EXPECT_NE(problem->find(words), std::string::npos) << *problem;
}

template <class O>
void expectValid(const KdTree<O>& tree) {
  const auto problem =
      validateTree(tree.nodes(), tree.view().references, tree.bounds(), tree.objectCount());
  EXPECT_FALSE(problem) << *problem;
}

/// A chain of splits, each in the right child of the one before, `levels` levels in all.
HandMadeTree spine(std::uint32_t levels) {
  HandMadeTree tree{.nodes = {}, .references = {}};
  for (std::uint32_t level = 1; level < levels; ++level) {
    tree.nodes.push_back(SplitNode(Axis::X, 4.0f - 4.0f / static_cast<float>(level), 2));
    tree.nodes.push_back(LeafNode(0, 0));
  }
  tree.nodes.push_back(LeafNode(0, 0));
  return tree;
}

TEST(ValidateTree, AcceptsBuiltTrees) {
  constexpr std::uint32_t kSeed = 75'025;
  test::MeshGenerator generator(kSeed);
  for (const BuildOptions& options : {BuildOptions{}, BuildOptions::textbook()}) {
    expectValid(buildTree(generator.soupOfAnyCoordinates<float>(3000, 0.1f), options));
    expectValid(buildTree(generator.soupOfAnyCoordinates<double>(3000, 0.1), options));
    expectValid(buildTree(generator.axisAlignedGrid<float>(500, 6), options));
    expectValid(buildTree(generator.coplanarSoup<float>(500, 60, Axis::Z, 3), options));
    expectValid(buildTree(generator.slivers<float>(300, 60), options));
    expectValid(buildTree(TriangleMesh<float>{}, options));
  }
}

TEST(ValidateTree, AcceptsTheHandMadeTree) {
  const auto problem = HandMadeTree{}.problem();
  EXPECT_FALSE(problem) << *problem;
}

TEST(ValidateTree, AcceptsPlanesOnTheWallsOfTheirCell) {
  HandMadeTree tree;
  tree.nodes[0] = SplitNode(Axis::X, 0.0f, 4);
  tree.nodes[1] = SplitNode(Axis::Y, 4.0f, 2);
  EXPECT_FALSE(tree.problem());
}

TEST(ValidateTree, NeedsARoot) {
  const auto problem = validateTree({}, {}, kBounds, 0);
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->find("root"), std::string::npos) << *problem;
}

TEST(ValidateTree, NamesARightChildBeyondTheArray) {
  for (const std::uint32_t offset : {5u, 6u, kMaxNodeCount}) {
    HandMadeTree tree;
    tree.nodes[0] = SplitNode(Axis::X, 2.0f, offset);
    expectProblem(tree, 0, "right child");
  }
}

TEST(ValidateTree, NamesARightChildThatIsTheNodeItselfOrItsLeftChild) {
  for (const std::uint32_t offset : {0u, 1u}) {
    HandMadeTree tree;
    tree.nodes[1] = SplitNode(Axis::Y, 1.0f, offset);
    expectProblem(tree, 1, "right child");
  }
}

TEST(ValidateTree, NamesChildrenThatOverlap) {
  // The root's right child is a node of its left subtree: two ways lead to it.
  for (const std::uint32_t offset : {2u, 3u}) {
    HandMadeTree tree;
    tree.nodes[0] = SplitNode(Axis::X, 2.0f, offset);
    expectProblem(tree, offset, "depth-first order");
  }
}

TEST(ValidateTree, NamesNodesThatNoOtherReaches) {
  HandMadeTree tree;
  tree.nodes.push_back(LeafNode(0, 0));
  expectProblem(tree, 5, "reached");
  // A gap between the left subtree and the right child.
  tree.nodes[0] = SplitNode(Axis::X, 2.0f, 5);
  expectProblem(tree, 5, "depth-first order");
}

TEST(ValidateTree, NamesALeafWithReferencesBeyondTheArray) {
  HandMadeTree tree;
  tree.nodes[4] = LeafNode(3, 4);
  expectProblem(tree, 4, "references beyond");
  tree.nodes[4] = LeafNode(7, 0);
  expectProblem(tree, 4, "references beyond");
  tree.nodes[4] = LeafNode(kMaxReferenceCount, 0xFFFF'FFFFu);
  expectProblem(tree, 4, "references beyond");
}

TEST(ValidateTree, NamesALeafWithAnObjectThatDoesNotExist) {
  HandMadeTree tree;
  tree.references[5] = 4;
  expectProblem(tree, 4, "object");
  tree.references[5] = 0xFFFF'FFFFu;
  expectProblem(tree, 4, "object");
}

TEST(ValidateTree, NamesALeafWhoseReferencesDoNotRise) {
  HandMadeTree tree;
  tree.references = {1, 0, 1, 1, 2, 3};
  expectProblem(tree, 2, "rise");
  tree.references = {0, 1, 1, 1, 2, 2};
  expectProblem(tree, 4, "rise");
}

TEST(ValidateTree, NamesAPlaneThatIsNoNumber) {
  for (const float position : {kNaN, kInfinity, -kInfinity}) {
    HandMadeTree tree;
    tree.nodes[1] = SplitNode(Axis::Y, position, 2);
    expectProblem(tree, 1, "outside its cell");
  }
}

TEST(ValidateTree, NamesAPlaneOutsideItsCell) {
  HandMadeTree tree;
  tree.nodes[1] = SplitNode(Axis::Y, std::nextafter(4.0f, 5.0f), 2);
  expectProblem(tree, 1, "outside its cell");
  // Inside the bounds, but in the other half.
  tree.nodes[1] = SplitNode(Axis::X, 2.5f, 2);
  expectProblem(tree, 1, "outside its cell");
}

TEST(ValidateTree, NamesASplitInBoundsThatAreEmptyOrNoNumbers) {
  const HandMadeTree tree;
  const Box3 noNumbers = {.lower = {kNaN, kNaN, kNaN}, .upper = {kNaN, kNaN, kNaN}};
  EXPECT_TRUE(validateTree(tree.nodes, tree.references, Box3{}, kObjectCount));
  EXPECT_TRUE(validateTree(tree.nodes, tree.references, noNumbers, kObjectCount));
}

TEST(ValidateTree, NamesASplitBelowTheGreatestDepth) {
  EXPECT_FALSE(spine(kMaxTreeDepth).problem());
  expectProblem(spine(kMaxTreeDepth + 1), 2 * (kMaxTreeDepth - 1), "greatest depth");
}

TEST(ValidateTree, RefusesAPathOfAMillionNodesAtOnce) {
  // To the left, so that it is the deepest path that a recursive check would take first.
  HandMadeTree tree{.nodes = {}, .references = {}};
  constexpr std::uint32_t kLevels = 1'000'000;
  for (std::uint32_t level = 1; level < kLevels; ++level)
    tree.nodes.push_back(SplitNode(Axis::X, 0.0f, 2 * (kLevels - level)));
  tree.nodes.resize(2 * kLevels - 1, LeafNode(0, 0));
  EXPECT_TRUE(tree.problem());
}

TEST(ValidateTree, NamesBoundsThatAreNoBox) {
  const std::vector<Node> nodes = {SplitNode(Axis::X, kInfinity, 2), LeafNode(0, 0),
                                   LeafNode(0, 0)};
  const Box3 everything = {.lower = {-kInfinity, -kInfinity, -kInfinity},
                           .upper = {kInfinity, kInfinity, kInfinity}};
  EXPECT_TRUE(validateTree(nodes, {}, everything, 0));
  const std::vector<Node> leaf = {LeafNode(0, 0)};
  EXPECT_TRUE(validateTree(leaf, {}, {.lower = {kNaN, 0, 0}, .upper = {1, 1, 1}}, 0));
  EXPECT_TRUE(validateTree(leaf, {}, {.lower = {1, 0, 0}, .upper = {0, 1, 1}}, 0));
  EXPECT_FALSE(validateTree(leaf, {}, Box3{}, 0));
}

TEST(ValidateTree, RefusesReferencesThatLeavesShareOrLeaveOut) {
  const std::vector<std::uint32_t> references = {0, 1};
  const std::vector<Node> shared = {SplitNode(Axis::X, 2.0f, 2), LeafNode(0, 2), LeafNode(0, 2)};
  EXPECT_TRUE(validateTree(shared, references, kBounds, 2));
  const std::vector<Node> gap = {SplitNode(Axis::X, 2.0f, 2), LeafNode(0, 0), LeafNode(1, 1)};
  EXPECT_TRUE(validateTree(gap, references, kBounds, 2));
  const std::vector<Node> rest = {SplitNode(Axis::X, 2.0f, 2), LeafNode(0, 1), LeafNode(1, 0)};
  EXPECT_TRUE(validateTree(rest, references, kBounds, 2));
}

TEST(ValidateTree, NamesEveryTruncation) {
  const HandMadeTree whole;
  for (std::size_t nodeCount = 0; nodeCount < whole.nodes.size(); ++nodeCount) {
    // Copies of just that size, so that the sanitizer sees a read beyond.
    const std::vector<Node> nodes(whole.nodes.begin(),
                                  whole.nodes.begin() + static_cast<std::ptrdiff_t>(nodeCount));
    EXPECT_TRUE(validateTree(nodes, whole.references, kBounds, kObjectCount)) << nodeCount;
  }
  for (std::size_t count = 0; count < whole.references.size(); ++count) {
    const std::vector<std::uint32_t> references(
        whole.references.begin(), whole.references.begin() + static_cast<std::ptrdiff_t>(count));
    EXPECT_TRUE(validateTree(whole.nodes, references, kBounds, kObjectCount)) << count;
  }
}

}  // namespace
}  // namespace planetree
