#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/node/node.hpp>

#include "support/memory_meter.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace planetree::detail {

/// A tree, or a part of one, while it is written: nodes depth first, and the references of their
/// leaves. Throws `Error` with `CapacityExceeded` where an offset would not fit.
class NodeArray {
 public:
  /// Adds a leaf of `count` objects and returns room for their numbers, to be filled in rising
  /// order before anything else is added.
  [[nodiscard]] std::span<std::uint32_t> addLeaf(std::size_t count);

  /// Room for the boxes of what the objects of the leaf that was added last have inside the cell,
  /// to be filled in the order of the objects.
  [[nodiscard]] std::span<Box3> boxesOfLastLeaf() noexcept;

  /// Adds a split whose right child is not known yet, and returns where it stands.
  [[nodiscard]] std::size_t addSplit(Axis axis, float position);

  /// Makes what is added next the right child of that split.
  void beginRightChild(std::size_t split);

  /// Takes back all that was added from a split on; `firstReference` is that of its first leaf.
  void removeFrom(std::size_t split, std::size_t firstReference);

  /// Counts what the arrays take, for as long as they live. To be called when they are full, and
  /// now and then before: a tree may grow far beyond the objects that it is made of.
  void chargeMemory(MemoryMeter& meter);

  [[nodiscard]] std::span<const Node> nodes() const noexcept { return nodes_; }
  [[nodiscard]] std::span<const std::uint32_t> references() const noexcept { return references_; }
  /// The box of each reference.
  [[nodiscard]] std::span<const Box3> boxes() const noexcept { return boxes_; }

 private:
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> references_;
  std::vector<Box3> boxes_;
  MemoryCharge charge_;
};

/// Throw `Error` with `CapacityExceeded` if a tree cannot have so many.
void requireNodeRoom(std::size_t nodeCount);
void requireReferenceRoom(std::size_t referenceCount);

}  // namespace planetree::detail
