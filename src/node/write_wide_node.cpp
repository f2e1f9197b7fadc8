#include "node/write_wide_node.hpp"

#include "support/assert.hpp"
#include "support/sort_by.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace planetree::detail {
namespace {

constexpr std::size_t kSlotCount = WideNode::kSlotCount;

/// The order of the slots of a node while it is written: the nearest is added first, and comes to
/// stand last.
class NearestFirst {
 public:
  void add(std::size_t slot) noexcept {
    PLANETREE_ASSERT(rest_ > 0);
    slots_[--rest_] = static_cast<std::uint8_t>(slot);
  }
  /// Slots without a child come before all.
  [[nodiscard]] SlotOrder finish() noexcept {
    const std::size_t filledCount = kSlotCount - rest_;
    for (std::size_t i = 0; i < rest_; ++i)
      slots_[i] = static_cast<std::uint8_t>(filledCount + i);
    return SlotOrder(slots_);
  }

 private:
  std::array<std::uint8_t, kSlotCount> slots_ = {};
  std::size_t rest_ = kSlotCount;
};

/// The same node with the largest boxes in the last slots. Rays that are content with any hit take
/// the last one first: the larger a box, the likelier it hides what lies behind.
WideNode sortedByArea(const WideNode& node) {
  const auto areaOf = [&](std::size_t slot) {
    const auto sizeAlong = [&](std::size_t axis) {
      return node.planes[2 * axis + 1][slot] - node.planes[2 * axis][slot];
    };
    const float x = sizeAlong(0);
    const float y = sizeAlong(1);
    const float z = sizeAlong(2);
    return x < 0.0f ? -1.0f : x * y + y * z + z * x;
  };
  std::array<std::uint8_t, kSlotCount> from;
  std::iota(from.begin(), from.end(), std::uint8_t{0});
  sortBy(from, areaOf);
  WideNode sorted;
  std::array<std::uint8_t, kSlotCount> to;
  for (std::size_t slot = 0; slot < kSlotCount; ++slot) {
    to[from[slot]] = static_cast<std::uint8_t>(slot);
    sorted.children[slot] = node.children[from[slot]];
    for (std::size_t side = 0; side < 6; ++side)
      sorted.planes[side][slot] = node.planes[side][from[slot]];
  }
  for (std::size_t octant = 0; octant < node.orders.size(); ++octant) {
    std::array<std::uint8_t, kSlotCount> order;
    for (std::size_t i = 0; i < kSlotCount; ++i)
      order[i] = to[node.orders[octant][i]];
    sorted.orders[octant] = SlotOrder(order);
  }
  return sorted;
}

WideNode emptyNode() noexcept {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  WideNode node = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::fill_n(node.planes[2 * axis], kSlotCount, kInfinity);
    std::fill_n(node.planes[2 * axis + 1], kSlotCount, -kInfinity);
  }
  return node;
}

void setBounds(WideNode& node, std::size_t slot, const Box3& box, const WideFrame& frame) noexcept {
  for (const Axis axis : kAxes) {
    const auto i = 2 * static_cast<std::size_t>(axis);
    // In double the difference of two floats is off by far less than the step that is added.
    const double center = static_cast<double>(frame.center[static_cast<std::size_t>(axis)]);
    node.planes[i][slot] = roundDown(static_cast<double>(box.lower[axis]) - center);
    node.planes[i + 1][slot] = roundUp(static_cast<double>(box.upper[axis]) - center);
  }
}

void addNearestFirst(std::span<const Part> parts, std::span<const Branch> branches,
                     std::size_t index, std::size_t octant, NearestFirst& order) noexcept {
  if (index == Branch::kNone)
    return;
  const Branch& branch = branches[index];
  if (branch.slot != Branch::kNone) {
    order.add(branch.slot);
    return;
  }
  const auto axis = static_cast<std::size_t>(parts[branch.part].axis);
  const bool comesFromAbove = (octant >> axis & 1u) != 0;
  addNearestFirst(parts, branches, comesFromAbove ? branch.right : branch.left, octant, order);
  addNearestFirst(parts, branches, comesFromAbove ? branch.left : branch.right, octant, order);
}

/// Divides the slots among the children of a split that becomes a part of a wide node.
class Branching {
 public:
  Branching(std::span<const Part> parts, std::span<const SlotPlan> plans,
            std::vector<Branch>& branches)
      : parts_(parts), plans_(plans), branches_(branches) {}

  std::size_t branchOut(std::size_t part, std::size_t slots, std::size_t leftSlots) {
    const std::size_t index = branches_.size();
    branches_.push_back({.part = part});
    const std::size_t leftBranch = child(leftChild(part), leftSlots);
    const std::size_t rightBranch = child(rightChild(parts_, part), slots - leftSlots);
    branches_[index].left = leftBranch;
    branches_[index].right = rightBranch;
    return index;
  }

 private:
  std::size_t child(std::size_t part, std::size_t slots) {
    if (parts_[part].isEmpty())
      return Branch::kNone;
    const std::uint8_t kind = plans_[part].leftSlots[slots];
    if (kind != SlotPlan::kNode && kind != SlotPlan::kRow)
      return branchOut(part, slots, kind);
    branches_.push_back({.part = part, .kind = kind, .slot = slotCount_++});
    return branches_.size() - 1;
  }

  std::span<const Part> parts_;
  std::span<const SlotPlan> plans_;
  std::vector<Branch>& branches_;
  std::size_t slotCount_ = 0;
};

}  // namespace

void branchOut(std::span<const Part> parts, std::span<const SlotPlan> plans, std::size_t part,
               std::vector<Branch>& branches) {
  branches.clear();
  Branching(parts, plans, branches).branchOut(part, kSlotCount, plans[part].leftSlotsOfNode);
}

WideChild childOf(std::span<const Part> parts, std::size_t part, std::uint8_t kind,
                  std::span<const std::uint32_t> nodeOf) noexcept {
  if (isNode(parts[part], kind))
    return WideChild::node(nodeOf[part]);
  return parts[part].blockCount > 0 ? WideChild::blocks(parts[part].first, parts[part].blockCount)
                                    : WideChild::object(parts[part].first);
}

WideNode makeWideNode(std::span<const Part> parts, std::span<const Branch> branches,
                      std::span<const std::uint32_t> nodeOf, const WideFrame& frame) {
  WideNode node = emptyNode();
  for (std::size_t octant = 0; octant < node.orders.size(); ++octant) {
    NearestFirst order;
    addNearestFirst(parts, branches, 0, octant, order);
    node.orders[octant] = order.finish();
  }
  for (const Branch& branch : branches) {
    if (branch.slot == Branch::kNone)
      continue;
    setBounds(node, branch.slot, parts[branch.part].bounds, frame);
    node.children[branch.slot] = childOf(parts, branch.part, branch.kind, nodeOf);
  }
  return sortedByArea(node);
}

}  // namespace planetree::detail
