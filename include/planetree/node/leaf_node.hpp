#pragma once

#include <planetree/node/node_layout.hpp>

#include <cstddef>
#include <cstdint>

namespace planetree {

/// A leaf: a run of references to objects. An eight-byte word that shares its form with
/// `SplitNode`.
class LeafNode {
 public:
  /// `firstReference` must be at most `kMaxReferenceCount`; `count` may have any value.
  constexpr LeafNode(std::uint32_t firstReference, std::uint32_t count) noexcept
      : link_(firstReference << detail::kTagBits | detail::kLeafTag), count_(count) {}

  /// Offset of the leaf's first reference in the tree's reference array.
  [[nodiscard]] constexpr std::uint32_t firstReference() const noexcept {
    return link_ >> detail::kTagBits;
  }
  /// How many objects the leaf holds; full width, never clamped.
  [[nodiscard]] constexpr std::uint32_t count() const noexcept { return count_; }

 private:
  friend class Node;

  std::uint32_t link_;
  std::uint32_t count_;
};

}  // namespace planetree
