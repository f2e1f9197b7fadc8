#include "split/tree_builder.hpp"

#include <planetree/split/find_best_split_plane.hpp>

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace planetree::detail {
namespace {

// Below this many references a subtree is too little work to hand to another thread.
constexpr std::size_t kParallelThreshold = 4096;

void addLeaf(const std::vector<Reference>& references, const Box3& cell, NodeArray& tree) {
  const std::span<std::uint32_t> objects = tree.addLeaf(references.size());
  std::transform(references.begin(), references.end(), objects.begin(),
                 [](const Reference& reference) { return reference.object; });
  std::transform(references.begin(), references.end(), tree.boxesOfLastLeaf().begin(),
                 [&](const Reference& reference) { return intersection(reference.bounds, cell); });
}

}  // namespace

void TreeBuilder::buildTree(std::vector<Reference> references, const Box3& cell,
                            std::uint32_t level, double budget, NodeArray& tree) const {
  if (mustBeLeaf(references.size(), level))
    return addLeaf(references, cell, tree);
  const std::optional<SplitPlane> plane = findBestSplitPlane(references, cell, options_);
  if (!plane || !isWorthIt(*plane, references.size()) || !fitsInto(budget, *plane))
    return addLeaf(references, cell, tree);

  const bool isLarge = references.size() >= kParallelThreshold;
  Division division = divide(std::move(references), *plane, cell);
  const auto total = static_cast<double>(division.left.size() + division.right.size());
  const auto budgetOf = [&](const std::vector<Reference>& side) {
    return side.empty() ? 0.0 : budget * (static_cast<double>(side.size()) / total);
  };
  const double leftBudget = budgetOf(division.left);
  const double rightBudget = budgetOf(division.right);

  const std::size_t split = tree.addSplit(plane->axis, plane->position);
  const auto buildLeft = [&] {
    buildTree(std::move(division.left), calculateLeftBBox(*plane, cell), level + 1, leftBudget,
              tree);
  };
  const auto buildRight = [&](NodeArray& right) {
    buildTree(std::move(division.right), calculateRightBBox(*plane, cell), level + 1, rightBudget,
              right);
  };
  if (isLarge) {
    NodeArray right;
    tbb::parallel_invoke(buildLeft, [&] { buildRight(right); });
    tree.beginRightChild(split);
    tree.append(right);
  } else {
    buildLeft();
    tree.beginRightChild(split);
    buildRight(tree);
  }
}

bool TreeBuilder::mustBeLeaf(std::size_t count, std::uint32_t level) const noexcept {
  return count <= options_.leafSize || level == depthLimit_;
}

bool TreeBuilder::isWorthIt(const SplitPlane& plane, std::size_t count) const noexcept {
  const bool hasEmptySide = plane.leftCount == 0 || plane.rightCount == 0;
  if (hasEmptySide && !options_.allowsEmptyCells)
    return false;
  return !options_.stopsByCost || plane.cost < options_.cost.leafCost(count);
}

bool TreeBuilder::fitsInto(double budget, const SplitPlane& plane) noexcept {
  return static_cast<double>(plane.leftCount + plane.rightCount) <= budget;
}

TreeBuilder::Division TreeBuilder::divide(std::vector<Reference> references,
                                          const SplitPlane& plane, const Box3& cell) const {
  Division division;
  division.left.reserve(plane.leftCount);
  division.right.reserve(plane.rightCount);
  std::vector<std::uint32_t> straddlingLeft;
  std::vector<std::uint32_t> straddlingRight;
  for (const Reference& reference : references) {
    const bool left = goesLeft(reference, plane, options_.planarRule);
    const bool right = goesRight(reference, plane, options_.planarRule);
    if (left && right) {
      straddlingLeft.push_back(static_cast<std::uint32_t>(division.left.size()));
      straddlingRight.push_back(static_cast<std::uint32_t>(division.right.size()));
    }
    if (left)
      division.left.push_back(reference);
    if (right)
      division.right.push_back(reference);
  }
  if (options_.clipsReferences) {
    clipStraddling(division.left, straddlingLeft, calculateLeftBBox(plane, cell));
    clipStraddling(division.right, straddlingRight, calculateRightBBox(plane, cell));
  }
  return division;
}

void TreeBuilder::clipStraddling(std::vector<Reference>& references,
                                 const std::vector<std::uint32_t>& straddling,
                                 const Box3& cell) const {
  std::vector<Reference> clipped;
  clipped.reserve(straddling.size());
  for (const std::uint32_t index : straddling)
    clipped.push_back(references[index]);
  clip_(cell, clipped);
  for (std::size_t i = 0; i < straddling.size(); ++i)
    references[straddling[i]] = clipped[i];
  std::erase_if(references, [](const Reference& r) { return r.bounds.isEmpty(); });
}

}  // namespace planetree::detail
