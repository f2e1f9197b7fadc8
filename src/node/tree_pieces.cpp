#include "node/tree_pieces.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace planetree::detail {
namespace {

/// Writes a subtree to its place in the whole.
void copySubtree(const NodeArray& subtree, std::size_t firstNode, std::size_t firstReference,
                 BinaryTree& tree) {
  const auto moved = [&](const Node& node) -> Node {
    if (!node.isLeaf())
      return node;
    return LeafNode(static_cast<std::uint32_t>(firstReference) + node.leaf().firstReference(),
                    node.leaf().count());
  };
  std::transform(subtree.nodes().begin(), subtree.nodes().end(),
                 tree.nodes.begin() + static_cast<std::ptrdiff_t>(firstNode), moved);
  std::copy(subtree.references().begin(), subtree.references().end(),
            tree.references.begin() + static_cast<std::ptrdiff_t>(firstReference));
}

}  // namespace

TreePieces::TreePieces(NodeArray subtree) : top_(1) {
  subtrees_.push_back(std::move(subtree));
}

TreePieces::TreePieces(Axis axis, float position, TreePieces left, TreePieces right) {
  top_.push_back({.axis = axis, .position = position});
  append(std::move(left));
  top_.front().right = static_cast<std::uint32_t>(top_.size());
  append(std::move(right));
}

std::size_t TreePieces::referenceCount() const noexcept {
  return std::accumulate(
      subtrees_.begin(), subtrees_.end(), std::size_t{0},
      [](std::size_t sum, const NodeArray& tree) { return sum + tree.references().size(); });
}

void TreePieces::append(TreePieces part) {
  const auto firstPlace = static_cast<std::uint32_t>(top_.size());
  const auto firstSubtree = static_cast<std::uint32_t>(subtrees_.size());
  for (Place place : part.top_) {
    if (place.isSplit())
      place.right += firstPlace;
    else
      place.subtree += firstSubtree;
    top_.push_back(place);
  }
  subtrees_.insert(subtrees_.end(), std::make_move_iterator(part.subtrees_.begin()),
                   std::make_move_iterator(part.subtrees_.end()));
}

BinaryTree joinPieces(const TreePieces& pieces) {
  const std::vector<TreePieces::Place>& top = pieces.top();
  std::vector<std::size_t> firstNode(top.size() + 1);
  std::vector<std::size_t> firstReference(top.size() + 1);
  for (std::size_t i = 0; i < top.size(); ++i) {
    const NodeArray* const subtree =
        top[i].isSplit() ? nullptr : &pieces.subtrees()[top[i].subtree];
    firstNode[i + 1] = firstNode[i] + (subtree != nullptr ? subtree->nodes().size() : 1);
    firstReference[i + 1] =
        firstReference[i] + (subtree != nullptr ? subtree->references().size() : 0);
  }
  requireNodeRoom(firstNode.back());
  requireReferenceRoom(firstReference.back());
  BinaryTree tree;
  tree.nodes.resize(firstNode.back(), LeafNode(0, 0));
  tree.references.resize(firstReference.back());
  tbb::parallel_for(std::size_t{0}, top.size(), [&](std::size_t i) {
    if (!top[i].isSplit()) {
      copySubtree(pieces.subtrees()[top[i].subtree], firstNode[i], firstReference[i], tree);
      return;
    }
    const auto rightOffset = static_cast<std::uint32_t>(firstNode[top[i].right] - firstNode[i]);
    tree.nodes[firstNode[i]] = SplitNode(top[i].axis, top[i].position, rightOffset);
  });
  return tree;
}

}  // namespace planetree::detail
