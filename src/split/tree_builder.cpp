#include "split/tree_builder.hpp"

#include "split/plane_search.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace planetree::detail {
namespace {

// Below this many references one thread builds a subtree alone.
constexpr std::size_t kSubtreeSize = 1u << 13u;
// After so many nodes a subtree counts its memory.
constexpr std::size_t kChargedNodeCount = 256;

void addLeaf(std::span<const Reference> references, const Box3& cell, NodeArray& tree) {
  const std::span<std::uint32_t> objects = tree.addLeaf(references.size());
  std::transform(references.begin(), references.end(), objects.begin(),
                 [](const Reference& reference) { return reference.object; });
  std::transform(references.begin(), references.end(), tree.boxesOfLastLeaf().begin(),
                 [&](const Reference& reference) { return intersection(reference.bounds, cell); });
}

}  // namespace

/// Builds subtrees one after the other, without taking memory for any cell: the references of the
/// cells that are still to be built lie on a stack, and those of the next one on top.
class TreeBuilder::SubtreeBuilder {
 public:
  explicit SubtreeBuilder(const TreeBuilder& builder)
      : builder_(builder), search_(builder.options_), divider_(builder.options_, builder.clip_) {}

  [[nodiscard]] NodeArray build(std::span<const Reference> references, const Task& task) {
    NodeArray tree;
    stack_.resize(references.size());
    std::ranges::copy(references, stack_.data());
    build(0, task, tree);
    tree.chargeMemory(builder_.monitor_.memory());
    builder_.monitor_.advance(task.part);
    return tree;
  }

 private:
  /// Builds the cell whose references lie on the stack from `begin` on, and takes them off.
  void build(std::size_t begin, const Task& task, NodeArray& tree) {
    if (tree.nodes().size() % kChargedNodeCount == 0)
      tree.chargeMemory(builder_.monitor_.memory());
    const std::span<const Reference> references = stack_.from(begin);
    const std::optional<SplitPlane> plane = builder_.findPlane(references, task, search_);
    if (!plane) {
      addLeaf(references, task.cell, tree);
      stack_.resize(begin);
      return;
    }
    divider_.divide(references, *plane, task.cell);
    const Children children =
        builder_.childrenOf(task, *plane, divider_.left().size(), divider_.right().size());
    const std::size_t beginLeft = begin + divider_.right().size();
    stack_.resize(beginLeft + divider_.left().size());
    std::ranges::copy(divider_.right(), stack_.data() + begin);
    std::ranges::copy(divider_.left(), stack_.data() + beginLeft);
    const std::size_t split = tree.addSplit(plane->axis, plane->position);
    build(beginLeft, children.left, tree);
    tree.beginRightChild(split);
    build(begin, children.right, tree);
  }

  const TreeBuilder& builder_;
  PlaneSearch search_;
  ReferenceDivider divider_;
  PlainArray<Reference> stack_;
};

/// What is used again. Lends a `SubtreeBuilder` to each thread that asks. Not by thread: while a
/// shape clips itself its thread may take up other work, and come back here.
class TreeBuilder::Workshop {
 public:
  explicit Workshop(const TreeBuilder& builder)
      : builder_(builder), pool_(builder.monitor_.memory()) {}

  [[nodiscard]] ReferencePool& pool() noexcept { return pool_; }

  template <class Work>
  auto with(const Work& work) {
    std::unique_ptr<SubtreeBuilder> lent = take();
    auto result = work(*lent);
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(lent));
    return result;
  }

 private:
  std::unique_ptr<SubtreeBuilder> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty())
      return std::make_unique<SubtreeBuilder>(builder_);
    std::unique_ptr<SubtreeBuilder> taken = std::move(free_.back());
    free_.pop_back();
    return taken;
  }

  const TreeBuilder& builder_;
  ReferencePool pool_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<SubtreeBuilder>> free_;
};

TreePieces TreeBuilder::build(CellReferences references, const Box3& cell, double budget) const {
  Workshop workshop(*this);
  return buildPieces(std::move(references), {.cell = cell, .level = 1, .budget = budget}, workshop);
}

TreePieces TreeBuilder::buildPieces(CellReferences cellReferences, const Task& task,
                                    Workshop& workshop) const {
  const std::span<const Reference> references = cellReferences.references.values();
  if (references.size() < kSubtreeSize) {
    TreePieces piece = workshop.with(
        [&](SubtreeBuilder& builder) { return TreePieces(builder.build(references, task)); });
    workshop.pool().giveBack(std::move(cellReferences));
    return piece;
  }
  // On the heap, and gone before the children are built: there may be as many on the way.
  const std::optional<SplitPlane> plane =
      findPlane(references, task, *std::make_unique<PlaneSearch>(options_));
  if (!plane) {
    NodeArray leaf;
    addLeaf(references, task.cell, leaf);
    leaf.chargeMemory(monitor_.memory());
    workshop.pool().giveBack(std::move(cellReferences));
    monitor_.advance(task.part);
    return TreePieces(std::move(leaf));
  }
  DividedReferences divided = divideTogether(std::move(cellReferences), *plane, task.cell, options_,
                                             clip_, workshop.pool());
  monitor_.throwIfStopped();
  const Children children =
      childrenOf(task, *plane, divided.left.references.size(), divided.right.references.size());
  std::optional<TreePieces> left;
  std::optional<TreePieces> right;
  tbb::parallel_invoke(
      [&] { left = buildPieces(std::move(divided.left), children.left, workshop); },
      [&] { right = buildPieces(std::move(divided.right), children.right, workshop); });
  monitor_.throwIfStopped();
  return {plane->axis, plane->position, std::move(*left), std::move(*right)};
}

std::optional<SplitPlane> TreeBuilder::findPlane(std::span<const Reference> references,
                                                 const Task& task, PlaneSearch& search) const {
  if (references.size() <= options_.leafSize || task.level == depthLimit_)
    return std::nullopt;
  const double limit = options_.stopsByCost ? options_.cost.leafCost(references.size())
                                            : std::numeric_limits<double>::infinity();
  const std::optional<SplitPlane> plane = search.find(references, task.cell, limit);
  monitor_.throwIfStopped();
  if (!plane)
    return std::nullopt;
  const bool hasEmptySide = plane->leftCount == 0 || plane->rightCount == 0;
  if (hasEmptySide && !options_.allowsEmptyCells)
    return std::nullopt;
  const auto total = static_cast<double>(plane->leftCount + plane->rightCount);
  return total <= task.budget ? plane : std::nullopt;
}

TreeBuilder::Children TreeBuilder::childrenOf(const Task& task, const SplitPlane& plane,
                                              std::size_t leftCount,
                                              std::size_t rightCount) noexcept {
  const auto total = static_cast<double>(leftCount + rightCount);
  const auto childOf = [&](const Box3& cell, std::size_t count) {
    const double share = count == 0 ? 0.0 : static_cast<double>(count) / total;
    return Task{.cell = cell,
                .level = task.level + 1,
                .budget = task.budget * share,
                .part = task.part * share};
  };
  return {.left = childOf(calculateLeftBBox(plane, task.cell), leftCount),
          .right = childOf(calculateRightBBox(plane, task.cell), rightCount)};
}

}  // namespace planetree::detail
