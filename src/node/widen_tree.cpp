#include "node/widen_tree.hpp"

#include <planetree/error.hpp>

#include "node/divide_leaf.hpp"
#include "support/assert.hpp"
#include "support/sort_by.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace planetree::detail {
namespace {

constexpr std::size_t kSlotCount = WideNode::kSlotCount;
constexpr std::size_t kNoChild = std::numeric_limits<std::size_t>::max();

// In terms of the test of a node, which takes as long as that of a block.
constexpr double kNodeCost = 1.0;
constexpr double kBlockCost = 1.0;
/// What memory is worth: a node that a random ray meets less often than an average triangle costs
/// more in caches than it saves. Two blocks in a row are then better than a node for them.
constexpr double kNodePerObjectCost = 3.2;

/// The cheapest way to give a part of the tree at most so many slots.
struct SlotPlan {
  /// Of all below, for a ray that meets the bounds of the tree, times their area. With no slot it
  /// is infinite, unless the part is empty.
  std::array<float, kSlotCount + 1> cost;
  /// How many of the slots go to the left child, or what the part is in a single one.
  std::array<std::uint8_t, kSlotCount + 1> leftSlots;
  /// The same for the node that the part would be.
  std::uint8_t leftSlotsOfNode;

  static constexpr std::uint8_t kNode = 0xFF;
  static constexpr std::uint8_t kRow = 0xFE;  ///< its blocks, one after the other
};

/// A part inside one wide node: what is in a slot, or a split.
struct Branch {
  std::size_t part;
  std::uint8_t kind = 0;        ///< of a split in a slot: what it is there
  std::size_t slot = kNoChild;  ///< if it is in one
  std::size_t left = kNoChild;  ///< index of a branch
  std::size_t right = kNoChild;
};

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

class Widener {
 public:
  Widener(std::span<const Node> nodes, std::span<const std::uint32_t> references,
          std::span<const Box3> boxes, const WideFrame& frame)
      : nodes_(nodes), references_(references), boxes_(boxes), frame_(frame) {}

  [[nodiscard]] WideTree run(LeafPacker& packer) {
    makeParts(packer);
    requireIndices();
    if (parts_.front().bounds.isEmpty())
      return {};
    plans_.resize(parts_.size());
    for (std::size_t i = parts_.size(); i-- > 0;)
      plan(i);
    const WideChild root = place(0, plans_.front().leftSlots[1]);
    return {frame_, root, wideNodes_, blocks_};
  }

 private:
  [[nodiscard]] bool isEmpty(std::size_t part) const noexcept {
    return parts_[part].bounds.isEmpty();
  }
  [[nodiscard]] std::size_t left(std::size_t part) const noexcept { return part + 1; }
  [[nodiscard]] std::size_t right(std::size_t part) const noexcept { return parts_[part].right; }

  /// Both are depth first, so that children come behind their parent.
  void makeParts(LeafPacker& packer) {
    std::vector<std::uint32_t> partOf(nodes_.size());
    LeafDivider divider;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      partOf[i] = static_cast<std::uint32_t>(parts_.size());
      if (nodes_[i].isLeaf())
        divideLeaf(nodes_[i].leaf(), packer, divider);
      else
        parts_.push_back({.axis = nodes_[i].split().axis()});
    }
    for (std::size_t i = nodes_.size(); i-- > 0;) {
      if (nodes_[i].isLeaf())
        continue;
      Part& split = parts_[partOf[i]];
      split.right = partOf[i + nodes_[i].split().rightOffset()];
      split.bounds = parts_[partOf[i + 1]].bounds;
      split.bounds.extend(parts_[split.right].bounds);
    }
  }

  void divideLeaf(const LeafNode& leaf, LeafPacker& packer, LeafDivider& divider) {
    const std::uint32_t first = leaf.firstReference();
    const bool isPacked = packer.open(references_.subspan(first, leaf.count()));
    divider.divide(boxes_.subspan(first, leaf.count()), isPacked ? &packer : nullptr, first, parts_,
                   blocks_);
  }

  /// That references fit, the binary form sees to.
  void requireIndices() const {
    static_assert(WideChild::kMaxReference == kMaxReferenceCount - 1);
    if (blocks_.size() > std::size_t{WideChild::kMaxBlockIndex} + 1)
      throwTooLarge("blocks");
  }
  [[noreturn]] static void throwTooLarge(const std::string& what) {
    throw Error(ErrorCode::CapacityExceeded, "the wide form of the tree has too many " + what,
                "Raise leafSize, or divide the scene into several trees.");
  }

  void plan(std::size_t index) {
    SlotPlan& plan = plans_[index];
    const Part& part = parts_[index];
    plan.leftSlots.fill(SlotPlan::kRow);
    plan.leftSlotsOfNode = 0;
    const double area = part.bounds.surfaceArea();
    const auto rowCost = static_cast<float>(area * kBlockCost * part.blockCount);
    if (!part.isSplit()) {
      plan.cost.fill(rowCost);
      if (!isEmpty(index))
        plan.cost[0] = std::numeric_limits<float>::infinity();
      return;
    }
    const SlotPlan& leftPlan = plans_[left(index)];
    const SlotPlan& rightPlan = plans_[right(index)];
    for (std::size_t slots = 0; slots <= kSlotCount; ++slots) {
      plan.cost[slots] = std::numeric_limits<float>::infinity();
      for (std::size_t leftSlots = 0; leftSlots <= slots; ++leftSlots) {
        const float cost = leftPlan.cost[leftSlots] + rightPlan.cost[slots - leftSlots];
        if (cost < plan.cost[slots]) {
          plan.cost[slots] = cost;
          plan.leftSlots[slots] = static_cast<std::uint8_t>(leftSlots);
        }
      }
    }
    plan.leftSlotsOfNode = plan.leftSlots[kSlotCount];
    const float nodeCost =
        static_cast<float>(area * kNodeCost + costOfNodeMemory()) + plan.cost[kSlotCount];
    const bool canBeRow = part.blockCount > 0 && part.blockCount <= WideChild::kMaxBlockCount;
    const bool isRow = canBeRow && rowCost <= nodeCost;
    for (std::size_t slots = 1; slots <= kSlotCount; ++slots) {
      const float cost = isRow ? rowCost : nodeCost;
      if (cost <= plan.cost[slots]) {
        plan.cost[slots] = cost;
        plan.leftSlots[slots] = isRow ? SlotPlan::kRow : SlotPlan::kNode;
      }
    }
  }

  [[nodiscard]] double costOfNodeMemory() const noexcept {
    return kNodePerObjectCost * parts_.front().bounds.surfaceArea() /
           static_cast<double>(references_.size());
  }

  /// Room for one more node, which is still to be written.
  std::size_t addNode() {
    const std::size_t index = wideNodes_.size();
    if (index > WideChild::kMaxNodeIndex)
      throwTooLarge("nodes");
    wideNodes_.emplace_back();
    return index;
  }

  /// Makes what a slot leads to that holds this part; a split as the node or row that `kind` says.
  WideChild place(std::size_t index, std::uint8_t kind) {
    const Part& part = parts_[index];
    if (part.isSplit() && kind != SlotPlan::kRow)
      return placeNode(index);
    return part.blockCount > 0 ? WideChild::blocks(part.first, part.blockCount)
                               : WideChild::object(part.first);
  }

  WideChild placeNode(std::size_t part) {
    const std::size_t index = addNode();
    std::vector<Branch> branches;
    std::size_t slotCount = 0;
    branchOut(part, kSlotCount, plans_[part].leftSlotsOfNode, branches, slotCount);

    WideNode wide = emptyNode();
    for (std::size_t octant = 0; octant < wide.orders.size(); ++octant)
      wide.orders[octant] = orderOf(branches, octant);
    for (const Branch& branch : branches) {
      if (branch.slot == kNoChild)
        continue;
      setBounds(wide, branch.slot, parts_[branch.part].bounds);
      wide.children[branch.slot] = place(branch.part, branch.kind);
    }
    wideNodes_[index] = sortedByArea(wide);
    return WideChild::node(static_cast<std::uint32_t>(index));
  }

  /// Divides the slots among the children of a split that becomes a part of a wide node.
  std::size_t branchOut(std::size_t part, std::size_t slots, std::size_t leftSlots,
                        std::vector<Branch>& branches, std::size_t& slotCount) {
    const std::size_t index = branches.size();
    branches.push_back({.part = part});
    const auto child = [&](std::size_t childPart, std::size_t childSlots) -> std::size_t {
      if (isEmpty(childPart))
        return kNoChild;
      const std::uint8_t kind = plans_[childPart].leftSlots[childSlots];
      if (kind != SlotPlan::kNode && kind != SlotPlan::kRow)
        return branchOut(childPart, childSlots, kind, branches, slotCount);
      branches.push_back({.part = childPart, .kind = kind, .slot = slotCount++});
      return branches.size() - 1;
    };
    const std::size_t leftBranch = child(left(part), leftSlots);
    const std::size_t rightBranch = child(right(part), slots - leftSlots);
    branches[index].left = leftBranch;
    branches[index].right = rightBranch;
    return index;
  }

  static WideNode emptyNode() {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    WideNode node = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::fill_n(node.planes[2 * axis], kSlotCount, kInfinity);
      std::fill_n(node.planes[2 * axis + 1], kSlotCount, -kInfinity);
    }
    return node;
  }

  void setBounds(WideNode& node, std::size_t slot, const Box3& box) const {
    for (const Axis axis : kAxes) {
      const auto i = 2 * static_cast<std::size_t>(axis);
      // In double the difference of two floats is off by far less than the step that is added.
      const double center = static_cast<double>(frame_.center[static_cast<std::size_t>(axis)]);
      node.planes[i][slot] = roundDown(static_cast<double>(box.lower[axis]) - center);
      node.planes[i + 1][slot] = roundUp(static_cast<double>(box.upper[axis]) - center);
    }
  }

  /// The slots as a ray meets them, farthest first; those without a child come before all.
  [[nodiscard]] SlotOrder orderOf(const std::vector<Branch>& branches, std::size_t octant) const {
    NearestFirst order;
    addNearestFirst(branches, 0, octant, order);
    return order.finish();
  }

  void addNearestFirst(const std::vector<Branch>& branches, std::size_t index, std::size_t octant,
                       NearestFirst& order) const {
    if (index == kNoChild)
      return;
    const Branch& branch = branches[index];
    if (branch.slot != kNoChild) {
      order.add(branch.slot);
      return;
    }
    const auto axis = static_cast<std::size_t>(parts_[branch.part].axis);
    const bool comesFromAbove = (octant >> axis & 1u) != 0;
    addNearestFirst(branches, comesFromAbove ? branch.right : branch.left, octant, order);
    addNearestFirst(branches, comesFromAbove ? branch.left : branch.right, octant, order);
  }

  std::span<const Node> nodes_;
  std::span<const std::uint32_t> references_;
  std::span<const Box3> boxes_;
  WideFrame frame_;
  std::vector<Part> parts_;
  std::vector<SlotPlan> plans_;
  std::vector<WideNode> wideNodes_;
  std::vector<TriangleBlock> blocks_;
};

}  // namespace

Vec3f centerOfWideTree(const Box3& bounds) noexcept {
  Vec3f center;
  for (const Axis axis : kAxes) {
    center[axis] = static_cast<float>(
        0.5 * (static_cast<double>(bounds.lower[axis]) + static_cast<double>(bounds.upper[axis])));
  }
  return center;
}

WideTree widenTree(std::span<const Node> nodes, std::span<const std::uint32_t> references,
                   std::span<const Box3> boxes, const Box3& bounds, LeafPacker& packer) {
  if (bounds.isEmpty())
    return {};
  WideFrame frame;
  const Vec3f center = centerOfWideTree(bounds);
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    frame.center[a] = center[axis];
    const auto middle = static_cast<double>(center[axis]);
    frame.halfSize[a] = roundUp(std::max(static_cast<double>(bounds.upper[axis]) - middle,
                                         middle - static_cast<double>(bounds.lower[axis])));
  }
  return Widener(nodes, references, boxes, frame).run(packer);
}

}  // namespace planetree::detail
