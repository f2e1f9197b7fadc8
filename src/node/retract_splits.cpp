#include "node/retract_splits.hpp"

#include "node/part.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace planetree::detail {
namespace {

/// Cells with more references than this are divided in any case: to divide them as leaves would
/// take long, and hardly ever pay.
constexpr std::size_t kMostReferences = 240;

/// Copies a subtree from the leaves upward, and looks at each split when both its sides are done.
class Retractor {
 public:
  Retractor(const NodeArray& tree, LeafCuts cuts, LeafPacker& packer, const SlotPlanner& planner)
      : tree_(tree), divider_(cuts, planner.weight()), packer_(packer), planner_(planner) {}

  [[nodiscard]] NodeArray run() {
    copy(0);
    return std::move(copy_);
  }

 private:
  /// Copies the subtree below a node. Its parts, planned, become the last ones.
  void copy(std::size_t index) {
    const Node& node = tree_.nodes()[index];
    const std::size_t firstPart = parts_.size();
    if (node.isLeaf()) {
      const std::size_t first = node.leaf().firstReference();
      const std::size_t count = node.leaf().count();
      const auto objects = tree_.references().subspan(first, count);
      const auto boxes = tree_.boxes().subspan(first, count);
      addLeaf(objects, boxes);
      addParts(objects, boxes);
      return;
    }
    const std::size_t split = copy_.addSplit(node.split().axis(), node.split().position());
    const std::size_t firstReference = copy_.references().size();
    parts_.push_back({.axis = node.split().axis()});
    copy(index + 1);
    copy_.beginRightChild(split);
    parts_[firstPart].right = static_cast<std::uint32_t>(parts_.size());
    copy(index + node.split().rightOffset());
    boundSplit(parts_, firstPart);
    planFrom(firstPart, firstPart + 1);
    if (copy_.references().size() - firstReference <= kMostReferences)
      retract(split, firstReference, firstPart);
  }

  /// Makes a finished split a leaf if that pays.
  void retract(std::size_t split, std::size_t firstReference, std::size_t firstPart) {
    gatherObjects(firstReference);
    const std::size_t end = parts_.size();
    const bool pays =
        addParts(objects_, boxes_) && plans_[end].cost[1] <= plans_[firstPart].cost[1];
    if (!pays)
      return dropFrom(end);
    for (Part& part : std::span(parts_).subspan(end)) {
      if (part.isSplit())
        part.right -= static_cast<std::uint32_t>(end - firstPart);
    }
    const auto oldBegin = static_cast<std::ptrdiff_t>(firstPart);
    const auto oldEnd = static_cast<std::ptrdiff_t>(end);
    parts_.erase(parts_.begin() + oldBegin, parts_.begin() + oldEnd);
    plans_.erase(plans_.begin() + oldBegin, plans_.begin() + oldEnd);
    copy_.removeFrom(split, firstReference);
    addLeaf(objects_, boxes_);
  }

  /// The objects of all references from the first one on, each once, with all that they have in
  /// their cells.
  void gatherObjects(std::size_t firstReference) {
    const auto references = copy_.references().subspan(firstReference);
    const auto boxes = copy_.boxes().subspan(firstReference);
    order_.resize(references.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return references[a] != references[b] ? references[a] < references[b] : a < b;
    });
    objects_.clear();
    boxes_.clear();
    for (const std::size_t i : order_) {
      if (!objects_.empty() && objects_.back() == references[i]) {
        boxes_.back().extend(boxes[i]);
      } else {
        objects_.push_back(references[i]);
        boxes_.push_back(boxes[i]);
      }
    }
  }

  void addLeaf(std::span<const std::uint32_t> objects, std::span<const Box3> boxes) {
    std::ranges::copy(objects, copy_.addLeaf(objects.size()).begin());
    std::ranges::copy(boxes, copy_.boxesOfLastLeaf().begin());
  }

  /// Adds the planned parts of a leaf. False if it is not packed.
  bool addParts(std::span<const std::uint32_t> objects, std::span<const Box3> boxes) {
    const std::size_t firstPart = parts_.size();
    const bool isPacked = packer_.open(objects);
    blocks_.clear();
    divider_.divide(objects, boxes, isPacked ? &packer_ : nullptr, parts_, blocks_);
    planFrom(firstPart, parts_.size());
    return isPacked;
  }

  void planFrom(std::size_t begin, std::size_t end) {
    plans_.resize(parts_.size());
    for (std::size_t i = end; i-- > begin;)
      planner_.plan(parts_, i, plans_);
  }

  void dropFrom(std::size_t part) {
    parts_.resize(part);
    plans_.resize(part);
  }

  const NodeArray& tree_;
  LeafDivider divider_;
  LeafPacker& packer_;
  const SlotPlanner& planner_;
  NodeArray copy_;
  std::vector<Part> parts_;
  std::vector<SlotPlan> plans_;

  // Room that is used again.
  std::vector<TriangleBlock> blocks_;
  std::vector<std::size_t> order_;
  std::vector<std::uint32_t> objects_;
  std::vector<Box3> boxes_;
};

}  // namespace

NodeArray retractSplits(const NodeArray& tree, LeafCuts cuts, LeafPacker& packer,
                        const SlotPlanner& planner) {
  return Retractor(tree, cuts, packer, planner).run();
}

}  // namespace planetree::detail
