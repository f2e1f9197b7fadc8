#include "node/widen_tree.hpp"

#include <planetree/error.hpp>

#include "geometry/longest_axis.hpp"
#include "support/assert.hpp"
#include "support/large_pages.hpp"
#include "support/sort_by.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

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
  static constexpr std::uint8_t kSlotForEachObject = 0xFE;
};

/// A part of the binary form inside one wide node: a subtree in a slot, a leaf whose objects have a
/// slot each, or a split.
struct Branch {
  std::size_t binary;           ///< index of the node
  std::size_t slot = kNoChild;  ///< the first one, if it is in slots
  std::size_t objectCount = 0;  ///< of a leaf whose objects have a slot each
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

/// Where a ray of an octant meets a box, to be compared with others; a guess, as boxes may overlap.
double entryInto(const Box3& box, std::size_t octant) noexcept {
  double entry = 0.0;
  for (const Axis axis : kAxes) {
    const bool comesFromAbove = (octant >> static_cast<std::size_t>(axis) & 1u) != 0;
    entry += comesFromAbove ? -static_cast<double>(box.upper[axis])
                            : static_cast<double>(box.lower[axis]);
  }
  return entry;
}

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
  Widener(std::span<const Node> nodes, std::span<const Box3> leafBounds,
          std::span<const Box3> boxes, WideTree& tree)
      : nodes_(nodes),
        leafBounds_(leafBounds),
        boxes_(boxes),
        tree_(tree),
        bounds_(nodes.size()),
        packed_(nodes.size()),
        plans_(nodes.size()) {}

  void run(const PackLeaf& packLeaf) {
    boundNodes();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].isLeaf() && !isEmpty(i))
        packed_[i] = pack(i, packLeaf);
    }
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
      if (!isEmpty(node))
        planLeaf(node);
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

  /// Objects on their own take a slot each, or a node for them; so do blocks if they are many.
  void planLeaf(std::size_t leaf) {
    SlotPlan& plan = plans_[leaf];
    const std::size_t count = nodes_[leaf].leaf().count();
    const auto area = static_cast<float>(bounds_[leaf].surfaceArea());
    plan.area.fill(packed_[leaf] && packed_[leaf]->isNode() ? area : 0.0f);
    plan.area[0] = std::numeric_limits<float>::infinity();
    if (packed_[leaf])
      return;
    for (std::size_t slots = 1; slots <= kSlotCount && count > 1; ++slots) {
      if (slots < count)
        plan.area[slots] = area;
      else
        plan.leftSlots[slots] = SlotPlan::kSlotForEachObject;
    }
  }

  /// Room for one more node, which is still to be written.
  std::size_t addNode() {
    const std::size_t index = tree_.nodes.size();
    if (index > WideChild::kMaxNodeIndex) {
      throw Error(ErrorCode::CapacityExceeded, "the wide form of the tree has too many nodes",
                  "Raise leafSize, or divide the scene into several trees.");
    }
    tree_.nodes.emplace_back();
    return index;
  }

  /// Makes what a slot with this subtree leads to.
  WideChild place(std::size_t node) {
    if (nodes_[node].isLeaf())
      return packed_[node] ? *packed_[node] : placeObjects(node);
    const std::size_t index = addNode();
    std::vector<Branch> branches;
    std::size_t slotCount = 0;
    branchOut(node, kSlotCount, plans_[node].leftSlotsOfNode, branches, slotCount);

    WideNode wide = emptyNode();
    for (const Branch& branch : branches) {
      if (branch.slot != kNoChild && branch.objectCount == 0)
        setBounds(wide, branch.slot, bounds_[branch.binary]);
      for (std::size_t i = 0; i < branch.objectCount; ++i)
        setBounds(wide, branch.slot + i, boxOf(branch.binary, referenceOf(branch.binary, i)));
    }
    for (std::size_t octant = 0; octant < wide.orders.size(); ++octant)
      wide.orders[octant] = orderOf(branches, octant);
    for (const Branch& branch : branches) {
      if (branch.slot != kNoChild && branch.objectCount == 0)
        wide.children[branch.slot] = place(branch.binary);
      for (std::size_t i = 0; i < branch.objectCount; ++i)
        wide.children[branch.slot + i] = WideChild::object(referenceOf(branch.binary, i));
    }
    tree_.nodes[index] = sortedByArea(wide);
    return WideChild::node(static_cast<std::uint32_t>(index));
  }

  /// What leads to the blocks of a leaf, or nothing if its objects do not go into blocks.
  std::optional<WideChild> pack(std::size_t leaf, const PackLeaf& packLeaf) {
    const std::size_t first = tree_.blocks.size();
    std::vector<Box3> bounds;
    if (!packLeaf(static_cast<std::uint32_t>(leaf), tree_.blocks, bounds))
      return std::nullopt;
    if (tree_.blocks.size() > WideChild::kMaxBlockIndex) {
      tree_.blocks.resize(first);
      return std::nullopt;
    }
    for (Box3& box : bounds)
      box = intersection(box, bounds_[leaf]);
    return placeRow(bounds, kBlocksTestedInARow, [&](std::size_t begin, std::size_t count) {
      return WideChild::blocks(static_cast<std::uint32_t>(first + begin),
                               static_cast<std::uint32_t>(count));
    });
  }

  /// Makes what leads to things in a row, each with its box: one child for up to `mostTogether` of
  /// them, which `childFor` gives; for more, nodes that divide the row.
  template <class ChildFor>
  WideChild placeRow(std::span<const Box3> boxes, std::size_t mostTogether,
                     const ChildFor& childFor, std::size_t first = 0) {
    if (boxes.size() <= mostTogether)
      return childFor(first, boxes.size());
    const std::size_t index = addNode();
    WideNode wide = emptyNode();
    std::vector<Box3> parts;
    const std::size_t partCount = std::min(boxes.size(), kSlotCount);
    for (std::size_t part = 0; part < partCount; ++part) {
      const std::size_t begin = boxes.size() * part / partCount;
      const auto run = boxes.subspan(begin, boxes.size() * (part + 1) / partCount - begin);
      Box3 box;
      for (const Box3& each : run)
        box.extend(each);
      if (box.isEmpty())
        continue;
      setBounds(wide, parts.size(), box);
      wide.children[parts.size()] = placeRow(run, mostTogether, childFor, first + begin);
      parts.push_back(box);
    }
    for (std::size_t octant = 0; octant < wide.orders.size(); ++octant)
      wide.orders[octant] = orderOf(parts, octant);
    tree_.nodes[index] = sortedByArea(wide);
    return WideChild::node(static_cast<std::uint32_t>(index));
  }

  [[nodiscard]] std::uint32_t referenceOf(std::size_t leaf, std::size_t object) const noexcept {
    return nodes_[leaf].leaf().firstReference() + static_cast<std::uint32_t>(object);
  }
  [[nodiscard]] const Box3& boxOf(std::size_t leaf, std::uint32_t reference) const noexcept {
    return boxes_.empty() ? bounds_[leaf] : boxes_[reference];
  }

  /// Makes what leads to the objects of a leaf that are on their own: each has a slot. If they are
  /// too many for one node they are divided along the longest axis.
  WideChild placeObjects(std::size_t leaf) {
    std::vector<std::uint32_t> references(nodes_[leaf].leaf().count());
    std::iota(references.begin(), references.end(), referenceOf(leaf, 0));
    if (references.size() > kSlotCount) {
      const Axis axis = longestAxis(bounds_[leaf]);
      sortBy(references, [&](std::uint32_t reference) {
        const Box3& box = boxOf(leaf, reference);
        return box.lower[axis] + box.upper[axis];
      });
    }
    std::vector<Box3> boxes;
    for (const std::uint32_t reference : references)
      boxes.push_back(boxOf(leaf, reference));
    return placeRow(boxes, 1, [&](std::size_t object, std::size_t) {
      return WideChild::object(references[object]);
    });
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
      if (next == SlotPlan::kSlotForEachObject) {
        const std::size_t count = nodes_[binary].leaf().count();
        branches.push_back({.binary = binary, .slot = slotCount, .objectCount = count});
        slotCount += count;
        return branches.size() - 1;
      }
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
      const double center = static_cast<double>(tree_.frame.center[static_cast<std::size_t>(axis)]);
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

  /// The same for slots of these boxes, from the first one on.
  [[nodiscard]] static SlotOrder orderOf(std::span<const Box3> boxes, std::size_t octant) {
    NearestFirst order;
    addNearestFirst(boxes, 0, octant, order);
    return order.finish();
  }

  void addNearestFirst(const std::vector<Branch>& branches, std::size_t index, std::size_t octant,
                       NearestFirst& order) const {
    if (index == kNoChild)
      return;
    const Branch& branch = branches[index];
    if (branch.objectCount > 0) {
      std::vector<Box3> boxes;
      for (std::size_t i = 0; i < branch.objectCount; ++i)
        boxes.push_back(boxOf(branch.binary, referenceOf(branch.binary, i)));
      addNearestFirst(boxes, branch.slot, octant, order);
      return;
    }
    if (branch.slot != kNoChild) {
      order.add(branch.slot);
      return;
    }
    const auto axis = static_cast<std::size_t>(nodes_[branch.binary].split().axis());
    const bool comesFromAbove = (octant >> axis & 1u) != 0;
    addNearestFirst(branches, comesFromAbove ? branch.right : branch.left, octant, order);
    addNearestFirst(branches, comesFromAbove ? branch.left : branch.right, octant, order);
  }
  static void addNearestFirst(std::span<const Box3> boxes, std::size_t firstSlot,
                              std::size_t octant, NearestFirst& order) {
    std::vector<std::size_t> places(boxes.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    sortBy(places, [&](std::size_t place) { return entryInto(boxes[place], octant); });
    for (const std::size_t place : places)
      order.add(firstSlot + place);
  }

  std::span<const Node> nodes_;
  std::span<const Box3> leafBounds_;
  std::span<const Box3> boxes_;
  WideTree& tree_;
  std::vector<Box3> bounds_;
  std::vector<std::optional<WideChild>> packed_;  ///< of leaves whose objects are in blocks
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
                   std::span<const Box3> boxes, const Box3& bounds, const PackLeaf& packLeaf) {
  WideTree tree;
  if (bounds.isEmpty())
    return tree;
  const Vec3f center = centerOfWideTree(bounds);
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    tree.frame.center[a] = center[axis];
    const auto middle = static_cast<double>(center[axis]);
    tree.frame.halfSize[a] = roundUp(std::max(static_cast<double>(bounds.upper[axis]) - middle,
                                              middle - static_cast<double>(bounds.lower[axis])));
  }
  Widener(nodes, leafBounds, boxes, tree).run(packLeaf);
  settle(tree.nodes);
  settle(tree.blocks);
  return tree;
}

}  // namespace planetree::detail
