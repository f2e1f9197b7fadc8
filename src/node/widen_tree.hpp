#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/node/node.hpp>

#include "node/wide_node.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace planetree::detail {

/// Puts the objects of a leaf that has some into blocks, behind those that are there. Nothing, and
/// no block, if they are not all triangles, or too many: then each object is on its own.
using PlaceLeaf = std::function<std::optional<WideChild>(std::uint32_t leafIndex,
                                                         std::vector<TriangleBlock>& blocks)>;

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
/// boxes are cheap, those of objects are not.
[[nodiscard]] WideTree widenTree(std::span<const Node> nodes, std::span<const Box3> leafBounds,
                                 std::span<const Box3> boxes, const Box3& bounds,
                                 const PlaceLeaf& placeLeaf);

}  // namespace planetree::detail
