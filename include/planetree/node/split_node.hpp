#pragma once

#include <planetree/geometry/axis.hpp>
#include <planetree/node/node_layout.hpp>

#include <cstdint>

namespace planetree {

class Node;

/// A split: the plane where the coordinate along `axis()` equals `position()`, and a child on each
/// side. An eight-byte word; children are found by their distance in the node array, never by
/// address, so that trees can be saved, mapped and shared. The left child is the next word.
class SplitNode {
 public:
  /// `rightOffset` is the distance to the right child, at least 2 and at most `kMaxNodeCount`.
  constexpr SplitNode(Axis axis, float position, std::uint32_t rightOffset) noexcept
      : link_(rightOffset << detail::kTagBits | static_cast<std::uint32_t>(axis)),
        position_(position) {}

  [[nodiscard]] constexpr Axis axis() const noexcept {
    return static_cast<Axis>(link_ & detail::kTagMask);
  }
  [[nodiscard]] constexpr float position() const noexcept { return position_; }
  [[nodiscard]] constexpr std::uint32_t rightOffset() const noexcept {
    return link_ >> detail::kTagBits;
  }

  /// The child below the plane. Only for a node inside a tree, not for a copy of one.
  [[nodiscard]] const Node& left() const noexcept;
  /// The child above the plane. Only for a node inside a tree, not for a copy of one.
  [[nodiscard]] const Node& right() const noexcept;

 private:
  friend class Node;

  std::uint32_t link_;
  float position_;
};

}  // namespace planetree

#include <planetree/node/node.hpp>
