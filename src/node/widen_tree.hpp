#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/node/node.hpp>

#include "node/leaf_packer.hpp"
#include "node/wide_node.hpp"

#include <cstdint>
#include <span>

namespace planetree::detail {

/// What the positions in the wide form are relative to: the middle of the tree's bounds, or a float
/// next to it within them. NaN if these are empty.
[[nodiscard]] Vec3f centerOfWideTree(const Box3& bounds) noexcept;

/// The wide form of a binary tree. `boxes` has what the object of each reference has inside the
/// cell of its leaf; `bounds` is that of the whole. Throws `Error` with `CapacityExceeded` where an
/// index would not fit.
///
/// Leaves are first divided by their objects, into blocks of triangles or single objects
/// (`LeafDivider`): cells that overlap a little cost less than to hold a triangle many times.
/// Which parts become nodes of their own is chosen so that what a random ray is expected to visit,
/// nodes and blocks, costs the least: by dynamic programming over the number of slots that a part
/// may take. Ylitie, Karras, Laine, "Efficient incoherent ray traversal on GPUs through compressed
/// wide BVHs", HPG 2017; here for a kd-tree, whose empty cells take no slot, and with a price for
/// memory. Linear in the parts.
[[nodiscard]] WideTree widenTree(std::span<const Node> nodes,
                                 std::span<const std::uint32_t> references,
                                 std::span<const Box3> boxes, const Box3& bounds,
                                 LeafPacker& packer);

}  // namespace planetree::detail
