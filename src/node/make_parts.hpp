#pragma once

#include "node/divide_leaf.hpp"
#include "node/leaf_packer.hpp"
#include "node/part.hpp"
#include "node/tree_pieces.hpp"
#include "node/triangle_block.hpp"
#include "node/visit_weight.hpp"
#include "support/memory_meter.hpp"
#include "support/plain_array.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace planetree::detail {

/// Makes a packer for one thread. May be called by several at once.
using MakeLeafPacker = std::function<std::unique_ptr<LeafPacker>()>;

/// The parts of a whole tree, each subtree of the binary form in one piece.
struct TreeParts {
  /// Where a subtree lies.
  struct Piece {
    std::size_t firstPart = 0;
    std::size_t partCount = 0;
    std::size_t firstBlock = 0;
    std::vector<TriangleBlock> blocks;
    MemoryCharge blocksCharge;
  };

  PlainArray<Part> parts;  ///< depth first
  MemoryCharge partsCharge;
  std::vector<std::size_t> tops;  ///< the splits above the pieces, parents before their children
  std::vector<Piece> pieces;
  std::size_t blockCount = 0;

  /// Calls `each` for all parts, children before their parents, those of different pieces at the
  /// same time.
  void forAllUpwards(const std::function<void(std::size_t part)>& each) const;
};

/// Divides the leaves of the pieces by their objects (`LeafDivider`), with what parts of the tree
/// weigh, in the current oneTBB arena,
/// and frees them one after the other. `advance` is told what part of the work has been done.
[[nodiscard]] TreeParts makeParts(TreePieces tree, const VisitWeight& weight, LeafCuts cuts,
                                  const MakeLeafPacker& makePacker, MemoryMeter& memory,
                                  const std::function<void(double part)>& advance);

}  // namespace planetree::detail
