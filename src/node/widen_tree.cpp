#include "node/widen_tree.hpp"

#include <planetree/error.hpp>

#include "support/assert.hpp"
#include "support/large_pages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace planetree::detail {
namespace {

constexpr std::size_t kSlotCount = WideNode::kSlotCount;
constexpr std::size_t kBlocksTestedInARow = 3;
static_assert(kBlocksTestedInARow <= WideChild::kMaxBlockCount);
constexpr std::size_t kNoChild = std::numeric_limits<std::size_t>::max();

/// The cheapest way to give a subtree of the binary form at most so many slots.
struct SlotPlan {
  /// The summed area of the wide nodes below, by the number of slots. With none it is infinite,
  /// unless the subtree is empty.
  std::array<float, kSlotCount + 1> area;
  /// How many of the slots go to the left child; `kOneSlot` if the subtree takes a single one.
  std::array<std::uint8_t, kSlotCount + 1> leftSlots;
  /// The same for the node that the subtree would be if it were given one slot.
  std::uint8_t leftSlotsOfNode;

  static constexpr std::uint8_t kOneSlot = 0xFF;
};

/// A part of the binary form inside one wide node: a subtree in a slot, or a split.
struct Branch {
  std::size_t binary;           ///< index of the node
  std::size_t slot = kNoChild;  ///< if it is in a slot
  std::size_t left = kNoChild;  ///< index of a branch
  std::size_t right = kNoChild;
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
  std::stable_sort(from.begin(), from.end(),
                   [&](std::uint8_t a, std::uint8_t b) { return areaOf(a) < areaOf(b); });
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
  Widener(std::span<const Node> nodes, std::span<const Box3> leafBounds, const PackLeaf& packLeaf,
          WideTree& tree)
      : nodes_(nodes),
        leafBounds_(leafBounds),
        packLeaf_(packLeaf),
        tree_(tree),
        bounds_(nodes.size()),
        plans_(nodes.size()) {}

  void run() {
    boundNodes();
    for (std::size_t i = nodes_.size(); i-- > 0;)
      plan(i);
    if (!bounds_.front().isEmpty())
      tree_.root = place(0);
  }

 private:
  [[nodiscard]] bool isEmpty(std::size_t node) const noexcept { return bounds_[node].isEmpty(); }
  [[nodiscard]] std::size_t left(std::size_t node) const noexcept { return node + 1; }
  [[nodiscard]] std::size_t right(std::size_t node) const noexcept {
    return node + nodes_[node].split().rightOffset();
  }

  /// Depth first, so that children come behind their parent.
  void boundNodes() {
    std::size_t leaf = leafBounds_.size();
    for (std::size_t i = nodes_.size(); i-- > 0;) {
      if (nodes_[i].isLeaf()) {
        bounds_[i] = leafBounds_[--leaf];
      } else {
        bounds_[i] = bounds_[left(i)];
        bounds_[i].extend(bounds_[right(i)]);
      }
    }
    PLANETREE_ASSERT(leaf == 0);
  }

  void plan(std::size_t node) {
    SlotPlan& plan = plans_[node];
    plan.leftSlots.fill(SlotPlan::kOneSlot);
    plan.leftSlotsOfNode = 0;
    if (isEmpty(node) || nodes_[node].isLeaf()) {
      plan.area.fill(0.0f);
      plan.area[0] = isEmpty(node) ? 0.0f : std::numeric_limits<float>::infinity();
      return;
    }
    const SlotPlan& leftPlan = plans_[left(node)];
    const SlotPlan& rightPlan = plans_[right(node)];
    for (std::size_t slots = 0; slots <= kSlotCount; ++slots) {
      plan.area[slots] = std::numeric_limits<float>::infinity();
      for (std::size_t leftSlots = 0; leftSlots <= slots; ++leftSlots) {
        const float area = leftPlan.area[leftSlots] + rightPlan.area[slots - leftSlots];
        if (area < plan.area[slots]) {
          plan.area[slots] = area;
          plan.leftSlots[slots] = static_cast<std::uint8_t>(leftSlots);
        }
      }
    }
    plan.leftSlotsOfNode = plan.leftSlots[kSlotCount];
    const float areaAsNode =
        static_cast<float>(bounds_[node].surfaceArea()) + plan.area[kSlotCount];
    for (std::size_t slots = 1; slots <= kSlotCount; ++slots) {
      if (areaAsNode <= plan.area[slots]) {
        plan.area[slots] = areaAsNode;
        plan.leftSlots[slots] = SlotPlan::kOneSlot;
      }
    }
  }

  /// Makes what a slot with this subtree leads to.
  WideChild place(std::size_t node) {
    if (nodes_[node].isLeaf())
      return placeLeaf(node);
    const std::size_t index = addNode();
    std::vector<Branch> branches;
    std::size_t slotCount = 0;
    branchOut(node, kSlotCount, plans_[node].leftSlotsOfNode, branches, slotCount);

    WideNode wide = emptyNode();
    for (const Branch& branch : branches) {
      if (branch.slot != kNoChild)
        setBounds(wide, branch.slot, bounds_[branch.binary]);
    }
    for (std::size_t octant = 0; octant < wide.orders.size(); ++octant)
      wide.orders[octant] = orderOf(branches, octant);
    for (const Branch& branch : branches) {
      if (branch.slot != kNoChild)
        wide.children[branch.slot] = place(branch.binary);
    }
    tree_.nodes[index] = sortedByArea(wide);
    return WideChild::node(static_cast<std::uint32_t>(index));
  }

  std::size_t addNode() {
    if (tree_.nodes.size() > WideChild::kMaxNodeIndex) {
      throw Error(ErrorCode::CapacityExceeded, "the wide form of the tree has too many nodes",
                  "Raise leafSize, or divide the scene into several trees.");
    }
    tree_.nodes.emplace_back();
    return tree_.nodes.size() - 1;
  }

  WideChild placeLeaf(std::size_t node) {
    const std::size_t first = tree_.blocks.size();
    std::vector<Box3> bounds;
    if (!packLeaf_(static_cast<std::uint32_t>(node), tree_.blocks, bounds))
      return WideChild::objects(static_cast<std::uint32_t>(node));
    if (tree_.blocks.size() > WideChild::kMaxBlockIndex) {
      tree_.blocks.resize(first);
      return WideChild::objects(static_cast<std::uint32_t>(node));
    }
    for (Box3& box : bounds)
      box = intersection(box, bounds_[node]);
    return placeBlocks(first, bounds);
  }

  /// A few blocks are tested one after the other; more of them get boxes of their own, in nodes
  /// whose order does not matter: these boxes overlap.
  WideChild placeBlocks(std::size_t first, std::span<const Box3> bounds) {
    if (bounds.size() <= kBlocksTestedInARow) {
      return WideChild::blocks(static_cast<std::uint32_t>(first),
                               static_cast<std::uint32_t>(bounds.size()));
    }
    const std::size_t index = addNode();
    WideNode wide = emptyNode();
    std::array<std::uint8_t, kSlotCount> slots = {};
    for (std::size_t slot = 0; slot < kSlotCount; ++slot) {
      slots[slot] = static_cast<std::uint8_t>(slot);
      const std::size_t begin = bounds.size() * slot / kSlotCount;
      const auto part = bounds.subspan(begin, bounds.size() * (slot + 1) / kSlotCount - begin);
      if (part.empty())
        continue;
      Box3 box;
      for (const Box3& each : part)
        box.extend(each);
      if (box.isEmpty())
        continue;
      setBounds(wide, slot, box);
      wide.children[slot] = placeBlocks(first + begin, part);
    }
    wide.orders.fill(SlotOrder(slots));
    tree_.nodes[index] = sortedByArea(wide);
    return WideChild::node(static_cast<std::uint32_t>(index));
  }

  /// Divides the slots among the children of a split that becomes a part of a wide node.
  std::size_t branchOut(std::size_t node, std::size_t slots, std::size_t leftSlots,
                        std::vector<Branch>& branches, std::size_t& slotCount) {
    const std::size_t index = branches.size();
    branches.push_back({.binary = node});
    const auto child = [&](std::size_t binary, std::size_t childSlots) -> std::size_t {
      if (isEmpty(binary))
        return kNoChild;
      const std::uint8_t next = plans_[binary].leftSlots[childSlots];
      if (!nodes_[binary].isLeaf() && next != SlotPlan::kOneSlot)
        return branchOut(binary, childSlots, next, branches, slotCount);
      branches.push_back({.binary = binary, .slot = slotCount++});
      return branches.size() - 1;
    };
    const std::size_t leftBranch = child(left(node), leftSlots);
    const std::size_t rightBranch = child(right(node), slots - leftSlots);
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
      const double center = static_cast<double>(tree_.center[axis]);
      node.planes[i][slot] = roundDown(static_cast<double>(box.lower[axis]) - center);
      node.planes[i + 1][slot] = roundUp(static_cast<double>(box.upper[axis]) - center);
    }
  }

  /// The slots as a ray meets them, farthest first; those without a child come before all.
  [[nodiscard]] SlotOrder orderOf(const std::vector<Branch>& branches, std::size_t octant) const {
    // Written from the end: the nearest is the last.
    std::array<std::uint8_t, kSlotCount> slots = {};
    std::size_t rest = kSlotCount;
    addNearestFirst(branches, 0, octant, slots, rest);
    const std::size_t filledCount = kSlotCount - rest;
    for (std::size_t i = 0; i < rest; ++i)
      slots[i] = static_cast<std::uint8_t>(filledCount + i);
    return SlotOrder(slots);
  }

  void addNearestFirst(const std::vector<Branch>& branches, std::size_t index, std::size_t octant,
                       std::array<std::uint8_t, kSlotCount>& slots, std::size_t& rest) const {
    if (index == kNoChild)
      return;
    const Branch& branch = branches[index];
    if (branch.slot != kNoChild) {
      PLANETREE_ASSERT(rest > 0);
      slots[--rest] = static_cast<std::uint8_t>(branch.slot);
      return;
    }
    const auto axis = static_cast<std::size_t>(nodes_[branch.binary].split().axis());
    const bool comesFromAbove = (octant >> axis & 1u) != 0;
    addNearestFirst(branches, comesFromAbove ? branch.right : branch.left, octant, slots, rest);
    addNearestFirst(branches, comesFromAbove ? branch.left : branch.right, octant, slots, rest);
  }

  std::span<const Node> nodes_;
  std::span<const Box3> leafBounds_;
  const PackLeaf& packLeaf_;
  WideTree& tree_;
  std::vector<Box3> bounds_;
  std::vector<SlotPlan> plans_;
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

WideTree widenTree(std::span<const Node> nodes, std::span<const Box3> leafBounds,
                   const Box3& bounds, const PackLeaf& packLeaf) {
  WideTree tree;
  if (bounds.isEmpty())
    return tree;
  tree.center = centerOfWideTree(bounds);
  Widener(nodes, leafBounds, packLeaf, tree).run();
  settle(tree.nodes);
  settle(tree.blocks);
  return tree;
}

}  // namespace planetree::detail
