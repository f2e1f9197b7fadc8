#pragma once

#include <planetree/geometry/box3.hpp>

#include "node/make_parts.hpp"
#include "node/tree_pieces.hpp"
#include "node/wide_node.hpp"
#include "support/memory_meter.hpp"

#include <cstddef>
#include <functional>

namespace planetree::detail {

/// What the positions in the wide form are relative to: the middle of the tree's bounds, or a float
/// next to it within them. NaN if these are empty.
[[nodiscard]] Vec3f centerOfWideTree(const Box3& bounds) noexcept;

/// The wide form of a binary tree; `bounds` is that of all its objects. Throws `Error` with
/// `CapacityExceeded` where an index would not fit. Runs in the current oneTBB arena; the result
/// does not depend on how many threads there are.
///
/// Leaves are first divided by their objects, into blocks of triangles or single objects
/// (`makeParts`): cells that overlap a little cost less than to hold a triangle many times. Which
/// parts become nodes of their own is planned over all of them (`SlotPlanner`). Linear in the
/// parts.
///
/// Frees the binary form as it goes, and counts what it takes itself. `advance` is told what part
/// of the work has been done; what it throws comes out.
[[nodiscard]] WideTree widenTree(TreePieces tree, const Box3& bounds, LeafCuts cuts,
                                 const MakeLeafPacker& makePacker, MemoryMeter& memory,
                                 const std::function<void(double part)>& advance);

/// Throw `Error` with `CapacityExceeded` if a wide tree cannot have so many.
void requireWideNodeRoom(std::size_t nodeCount);
void requireBlockRoom(std::size_t blockCount);

}  // namespace planetree::detail
