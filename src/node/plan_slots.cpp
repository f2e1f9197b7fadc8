#include "node/plan_slots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planetree::detail {
namespace {

constexpr std::size_t kSlotCount = WideNode::kSlotCount;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// In terms of the test of a node, which takes as long as that of a block.
constexpr double kNodeCost = 1.0;
constexpr double kBlockCost = 1.0;
/// What memory is worth: a node that a random ray meets less often than an average triangle costs
/// more in caches than it saves. Two blocks in a row are then better than a node for them.
constexpr double kNodePerObjectCost = 3.2;

/// A power of two that brings the area of a tree near 1, so that costs in float cannot overflow,
/// and are rounded alike at all scales.
double scaleFor(double treeArea) noexcept {
  return treeArea > 0.0 ? std::ldexp(1.0, -std::ilogb(treeArea)) : 1.0;
}

}  // namespace

SlotPlanner::SlotPlanner(const Box3& tree, std::size_t referenceCount) noexcept
    : weight_(tree),
      scale_(scaleFor(tree.surfaceArea())),
      nodeMemoryCost_(kNodePerObjectCost * tree.surfaceArea() * scale_ /
                      static_cast<double>(referenceCount)) {}

void SlotPlanner::plan(std::span<const Part> parts, std::size_t index,
                       std::span<SlotPlan> plans) const noexcept {
  SlotPlan& plan = plans[index];
  const Part& part = parts[index];
  const double weight = weight_(part.bounds) * scale_;
  const auto rowCost = static_cast<float>(weight * kBlockCost * part.blockCount);
  plan.leftSlots.fill(SlotPlan::kRow);
  plan.leftSlotsOfNode = 0;
  if (!part.isSplit()) {
    plan.cost.fill(rowCost);
    if (!part.isEmpty())
      plan.cost[0] = kInfinity;
    return;
  }
  const SlotPlan& left = plans[leftChild(index)];
  const SlotPlan& right = plans[rightChild(parts, index)];
  // All slot counts at once for each number of left slots, which compilers make vectors of.
  std::array<std::uint32_t, kSlotCount + 1> leftSlotsOf = {};
  plan.cost.fill(kInfinity);
  for (std::uint32_t leftSlots = 0; leftSlots <= kSlotCount; ++leftSlots) {
    const float leftCost = left.cost[leftSlots];
    for (std::size_t rightSlots = 0; rightSlots <= kSlotCount - leftSlots; ++rightSlots) {
      const std::size_t slots = leftSlots + rightSlots;
      const float cost = leftCost + right.cost[rightSlots];
      leftSlotsOf[slots] = cost < plan.cost[slots] ? leftSlots : leftSlotsOf[slots];
      plan.cost[slots] = cost < plan.cost[slots] ? cost : plan.cost[slots];
    }
  }
  std::transform(leftSlotsOf.begin(), leftSlotsOf.end(), plan.leftSlots.begin(),
                 [](std::uint32_t slots) { return static_cast<std::uint8_t>(slots); });
  plan.leftSlotsOfNode = plan.leftSlots[kSlotCount];
  const float nodeCost =
      static_cast<float>(weight * kNodeCost + nodeMemoryCost_) + plan.cost[kSlotCount];
  const bool canBeRow = part.blockCount > 0 && part.blockCount <= WideChild::kMaxBlockCount;
  const bool isRow = canBeRow && rowCost <= nodeCost;
  const float oneSlotCost = isRow ? rowCost : nodeCost;
  for (std::size_t slots = 1; slots <= kSlotCount; ++slots) {
    if (oneSlotCost <= plan.cost[slots]) {
      plan.cost[slots] = oneSlotCost;
      plan.leftSlots[slots] = isRow ? SlotPlan::kRow : SlotPlan::kNode;
    }
  }
}

}  // namespace planetree::detail
