#pragma once

#include "node/triangle_block.hpp"

#include <cstdint>
#include <span>

namespace planetree::detail {

/// Puts triangles of one leaf into blocks. Only this side knows what a triangle is.
class LeafPacker {
 public:
  LeafPacker() = default;
  LeafPacker(const LeafPacker&) = delete;
  LeafPacker& operator=(const LeafPacker&) = delete;
  virtual ~LeafPacker() = default;

  /// Turns to a leaf with these objects, by their numbers in the tree. False if they are not all
  /// triangles: then each is on its own, and what follows is not asked.
  virtual bool open(std::span<const std::uint32_t> objects) = 0;

  /// `counts[i]` becomes the number of blocks that the first i + 1 of these objects take, filled
  /// one after the other. `places` are indices into the objects of the leaf.
  virtual void countBlocks(std::span<const std::uint32_t> places,
                           std::span<std::uint32_t> counts) = 0;

  /// The block with these objects, which fit into one.
  [[nodiscard]] virtual TriangleBlock pack(std::span<const std::uint32_t> places) = 0;
};

}  // namespace planetree::detail
