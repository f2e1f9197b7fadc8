#pragma once

#include <planetree/geometry/axis.hpp>
#include <planetree/node/node.hpp>

#include "node/node_array.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace planetree::detail {

/// A tree in the pieces in which threads build it: finished subtrees, and the splits above them.
/// Where it is cut depends on the tree alone, never on the threads.
class TreePieces {
 public:
  /// A split, or a place that a subtree takes.
  struct Place {
    Axis axis = Axis::X;
    float position = 0.0f;
    std::uint32_t right = 0;    ///< of a split: index of its right child, the left one comes next
    std::uint32_t subtree = 0;  ///< of a subtree: its index

    [[nodiscard]] bool isSplit() const noexcept { return right != 0; }
  };

  /// A tree of one piece.
  explicit TreePieces(NodeArray subtree);
  /// A split of two.
  TreePieces(Axis axis, float position, TreePieces left, TreePieces right);

  /// Depth first.
  [[nodiscard]] const std::vector<Place>& top() const noexcept { return top_; }
  /// In the order of their places.
  [[nodiscard]] const std::vector<NodeArray>& subtrees() const noexcept { return subtrees_; }
  [[nodiscard]] std::size_t referenceCount() const noexcept;

  /// Changes what is in a place.
  void replaceSubtree(std::size_t index, NodeArray subtree) noexcept {
    subtrees_[index] = std::move(subtree);
  }
  /// Hands a subtree over, and leaves an empty one in its place.
  [[nodiscard]] NodeArray takeSubtree(std::size_t index) noexcept {
    return std::exchange(subtrees_[index], NodeArray());
  }

 private:
  void append(TreePieces part);

  std::vector<Place> top_;
  std::vector<NodeArray> subtrees_;
};

/// The binary form: nodes depth first, and the references of their leaves.
struct BinaryTree {
  std::vector<Node> nodes;
  std::vector<std::uint32_t> references;
};

/// Puts the pieces together, in the current oneTBB arena. Throws `Error` with `CapacityExceeded`
/// where an offset would not fit.
[[nodiscard]] BinaryTree joinPieces(const TreePieces& pieces);

}  // namespace planetree::detail
