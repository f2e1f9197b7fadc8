#pragma once

#include "node/part.hpp"
#include "node/visit_weight.hpp"
#include "node/wide_node.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace planetree::detail {

/// The cheapest way to give a part of the tree at most so many slots of a wide node.
struct SlotPlan {
  /// Of all below, times how often rays meet it, as the planner scales that. Infinite with no slot,
  /// unless the part is empty, and with no other count.
  std::array<float, WideNode::kSlotCount + 1> cost;
  /// How many of the slots go to the left child, or what the part is in a single one.
  std::array<std::uint8_t, WideNode::kSlotCount + 1> leftSlots;
  /// The same for the node that the part would be.
  std::uint8_t leftSlotsOfNode;

  static constexpr std::uint8_t kNode = 0xFF;
  static constexpr std::uint8_t kRow = 0xFE;  ///< its blocks, one after the other
};

/// Chooses which parts become nodes of their own, so that what a random ray is expected to visit,
/// nodes and blocks, costs the least: by dynamic programming over the number of slots that a part
/// may take. Ylitie, Karras, Laine, "Efficient incoherent ray traversal on GPUs through compressed
/// wide BVHs", HPG 2017; here for a kd-tree, whose empty cells take no slot, and with a price for
/// memory.
class SlotPlanner {
 public:
  /// For a tree with these bounds and so many references.
  SlotPlanner(const Box3& tree, std::size_t referenceCount) noexcept;

  /// How often it takes rays to meet a part.
  [[nodiscard]] const VisitWeight& weight() const noexcept { return weight_; }

  /// Plans a part; its children must be planned.
  void plan(std::span<const Part> parts, std::size_t index,
            std::span<SlotPlan> plans) const noexcept;

 private:
  VisitWeight weight_;
  double scale_;
  double nodeMemoryCost_;
};

}  // namespace planetree::detail
