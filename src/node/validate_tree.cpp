#include <planetree/node/validate_tree.hpp>

#include <cstddef>
#include <vector>

namespace planetree {
namespace {

struct Cell {
  std::size_t node;
  Box3 box;
  std::uint32_t level;
};

std::string atNode(std::size_t node, const std::string& problem) {
  return "node " + std::to_string(node) + " " + problem;
}

std::optional<std::string> validateLeaf(const LeafNode& leaf, std::size_t node,
                                        std::uint64_t expectedReference,
                                        std::span<const std::uint32_t> references,
                                        std::uint64_t objectCount) {
  const std::uint64_t end = std::uint64_t{leaf.firstReference()} + leaf.count();
  if (end > references.size())
    return atNode(node, "names references beyond the last");
  if (leaf.firstReference() != expectedReference)
    return atNode(node, "does not begin where the references of the last leaf end");
  for (std::uint64_t i = leaf.firstReference(); i < end; ++i) {
    if (references[i] >= objectCount)
      return atNode(node, "names an object that does not exist");
    if (i > leaf.firstReference() && references[i - 1] >= references[i]) {
      return atNode(node, "has references that do not rise");
    }
  }
  return std::nullopt;
}

std::optional<std::string> validateSplit(const SplitNode& split, const Cell& cell,
                                         std::size_t nodeCount) {
  const float lower = cell.box.lower[split.axis()];
  const float upper = cell.box.upper[split.axis()];
  if (!(split.position() >= lower && split.position() <= upper)) {
    return atNode(cell.node, "splits outside its cell");
  }
  if (split.rightOffset() < 2 || split.rightOffset() >= nodeCount - cell.node) {
    return atNode(cell.node, "has no right child inside the tree");
  }
  if (cell.level >= kMaxTreeDepth)
    return atNode(cell.node, "splits beyond the greatest depth");
  return std::nullopt;
}

}  // namespace

std::optional<std::string> validateTree(std::span<const Node> nodes,
                                        std::span<const std::uint32_t> references,
                                        const Box3& bounds, std::uint64_t objectCount) {
  if (nodes.empty())
    return "the tree has no root";
  const bool isFiniteBox = isFinite(bounds.lower) && isFinite(bounds.upper);
  if (bounds != Box3{} && (!isFiniteBox || bounds.isEmpty()))
    return "the bounds are neither a finite box nor empty";
  std::vector<Cell> cells = {{0, bounds, 1}};
  std::size_t expected = 0;
  std::uint64_t expectedReference = 0;
  while (!cells.empty()) {
    const Cell cell = cells.back();
    cells.pop_back();
    // Depth-first order: each node is the one behind the last, or the children overlap.
    if (cell.node != expected++)
      return atNode(cell.node, "is not where depth-first order puts it");
    const Node& node = nodes[cell.node];
    if (node.isLeaf()) {
      auto problem =
          validateLeaf(node.leaf(), cell.node, expectedReference, references, objectCount);
      if (problem)
        return problem;
      expectedReference += node.leaf().count();
      continue;
    }
    const SplitNode& split = node.split();
    if (auto problem = validateSplit(split, cell, nodes.size()))
      return problem;
    cells.push_back({cell.node + split.rightOffset(),
                     rightPart(cell.box, split.axis(), split.position()), cell.level + 1});
    cells.push_back(
        {cell.node + 1, leftPart(cell.box, split.axis(), split.position()), cell.level + 1});
  }
  if (expected != nodes.size())
    return atNode(expected, "is reached from no other");
  if (expectedReference != references.size())
    return "reference " + std::to_string(expectedReference) + " belongs to no leaf";
  return std::nullopt;
}

}  // namespace planetree
