#pragma once

#include <planetree/node/leaf_node.hpp>
#include <planetree/node/split_node.hpp>

#include <cstdint>
#include <type_traits>

namespace planetree {

/// One word of a tree: a `SplitNode` or a `LeafNode`. A tree is an array of them, depth first, the
/// root in front.
class alignas(8) Node {
 public:
  constexpr Node(SplitNode split) noexcept : split_(split) {}  // NOLINT: a split is a node
  constexpr Node(LeafNode leaf) noexcept : leaf_(leaf) {}      // NOLINT: a leaf is a node

  [[nodiscard]] bool isLeaf() const noexcept {
    // Both members start with the link, so it may be read through either.
    return (split_.link_ & detail::kTagMask) == detail::kLeafTag;
  }
  /// Only if this is no leaf.
  [[nodiscard]] constexpr const SplitNode& split() const noexcept { return split_; }
  /// Only if this is a leaf.
  [[nodiscard]] constexpr const LeafNode& leaf() const noexcept { return leaf_; }

 private:
  union {
    SplitNode split_;
    LeafNode leaf_;
  };
};

static_assert(sizeof(Node) == 8 && alignof(Node) == 8);
static_assert(sizeof(SplitNode) == sizeof(Node) && sizeof(LeafNode) == sizeof(Node));
static_assert(std::is_standard_layout_v<Node> && std::is_trivially_copyable_v<Node>);
static_assert(SplitNode(Axis::Z, -1.5f, kMaxNodeCount).axis() == Axis::Z);
static_assert(SplitNode(Axis::Z, -1.5f, kMaxNodeCount).position() == -1.5f);
static_assert(SplitNode(Axis::Z, -1.5f, kMaxNodeCount).rightOffset() == kMaxNodeCount);
static_assert(LeafNode(kMaxReferenceCount, 0xFFFF'FFFFu).firstReference() == kMaxReferenceCount);
static_assert(LeafNode(kMaxReferenceCount, 0xFFFF'FFFFu).count() == 0xFFFF'FFFFu);

// A standard-layout object and its first member share their address, and so do a union and its
// members: from the address of a split in a tree one may step along the array of nodes.
inline const Node& SplitNode::left() const noexcept {
  return reinterpret_cast<const Node*>(this)[1];
}
inline const Node& SplitNode::right() const noexcept {
  return reinterpret_cast<const Node*>(this)[rightOffset()];
}

}  // namespace planetree
