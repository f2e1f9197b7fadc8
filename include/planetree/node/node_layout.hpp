#pragma once

#include <cstdint>

namespace planetree {

/// The most levels a tree can have. The builder's depth limit and the traversal's stack are this
/// one constant, so that no tree can overflow the stack.
inline constexpr std::uint32_t kMaxTreeDepth = 64;

/// The most nodes a tree can have: what the offset to a right child can count.
inline constexpr std::uint32_t kMaxNodeCount = (1u << 30) - 1;

/// The most references a tree can have: what the offset of a leaf can count.
inline constexpr std::uint32_t kMaxReferenceCount = (1u << 30) - 1;

namespace detail {

// The lower word of a node: two bits of tag (the split axis, or the leaf tag), thirty of offset.
inline constexpr std::uint32_t kTagBits = 2;
inline constexpr std::uint32_t kTagMask = 3;
inline constexpr std::uint32_t kLeafTag = 3;

}  // namespace detail
}  // namespace planetree
