#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/node/node.hpp>

#include "node/wide_node.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace planetree::detail {

/// Adds the objects of a leaf that has some to the blocks, and the box around each new block to
/// `bounds`. False, and no change, if they are not all triangles: then each object is on its own.
using PackLeaf = std::function<bool(std::uint32_t leafIndex, std::vector<TriangleBlock>& blocks,
                                    std::vector<Box3>& bounds)>;

/// What the positions in the wide form are relative to: the middle of the tree's bounds, or a float
/// next to it within them. NaN if these are empty.
[[nodiscard]] Vec3f centerOfWideTree(const Box3& bounds) noexcept;

/// The wide form of a binary tree. `leafBounds` has the box of the contents of each leaf, in the
/// order of the leaves, and `boxes` that of each reference; without boxes every object gets that of
/// its leaf. `bounds` is that of the whole. Linear in the nodes, but for large leaves of objects on
/// their own, which are divided further.
///
/// Which subtrees become nodes of their own is chosen so that the area of all wide nodes, and with
/// it the number that a random ray visits, is smallest: by dynamic programming over the number of
/// slots that a subtree may take. Ylitie, Karras, Laine, "Efficient incoherent ray traversal on
/// GPUs through compressed wide BVHs", HPG 2017; here for a kd-tree, whose empty cells take no
/// slot, and a leaf of objects on their own takes one for each, or a node of its own: tests of
/// boxes are cheap, those of objects are not. Leaves of many blocks become nodes as well.
[[nodiscard]] WideTree widenTree(std::span<const Node> nodes, std::span<const Box3> leafBounds,
                                 std::span<const Box3> boxes, const Box3& bounds,
                                 const PackLeaf& packLeaf);

}  // namespace planetree::detail
