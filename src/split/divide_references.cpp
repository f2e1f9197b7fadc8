#include "split/divide_references.hpp"

#include <planetree/split/find_best_split_plane.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace planetree::detail {
namespace {

// What one thread divides at a time.
constexpr std::size_t kBatchSize = 1u << 14u;

}  // namespace

void ReferenceDivider::divide(std::span<const Reference> references, const SplitPlane& plane,
                              const Box3& cell) {
  const std::size_t count = references.size();
  left_.resize(count);
  right_.resize(count);
  straddlingLeft_.resize(count);
  straddlingRight_.resize(count);
  const std::size_t straddlingCount =
      plane.axis == Axis::X   ? divideAlong<Axis::X>(references, plane)
      : plane.axis == Axis::Y ? divideAlong<Axis::Y>(references, plane)
                              : divideAlong<Axis::Z>(references, plane);
  if (options_.clipsReferences && straddlingCount > 0) {
    clipStraddling(left_, straddlingLeft_.values().first(straddlingCount),
                   calculateLeftBBox(plane, cell));
    clipStraddling(right_, straddlingRight_.values().first(straddlingCount),
                   calculateRightBBox(plane, cell));
  }
}

template <Axis kAxis>
std::size_t ReferenceDivider::divideAlong(std::span<const Reference> references,
                                          const SplitPlane& plane) noexcept {
  SplitPlane along = plane;
  along.axis = kAxis;  // known to the compiler from here on
  const PlanarRule rule = options_.planarRule;
  // Each reference is written to both sides, and stays where it belongs: a branch would be guessed
  // wrong for half of them.
  std::size_t leftCount = 0;
  std::size_t rightCount = 0;
  std::size_t straddlingCount = 0;
  for (const Reference& reference : references) {
    const bool isLeft = goesLeft(reference, along, rule);
    const bool isRight = goesRight(reference, along, rule);
    left_.data()[leftCount] = reference;
    right_.data()[rightCount] = reference;
    straddlingLeft_.data()[straddlingCount] = static_cast<std::uint32_t>(leftCount);
    straddlingRight_.data()[straddlingCount] = static_cast<std::uint32_t>(rightCount);
    leftCount += isLeft ? 1 : 0;
    rightCount += isRight ? 1 : 0;
    straddlingCount += isLeft && isRight ? 1 : 0;
  }
  left_.resize(leftCount);
  right_.resize(rightCount);
  return straddlingCount;
}

void ReferenceDivider::clipStraddling(PlainArray<Reference>& side,
                                      std::span<const std::uint32_t> straddling, const Box3& cell) {
  clipped_.resize(straddling.size());
  for (std::size_t i = 0; i < straddling.size(); ++i)
    clipped_.data()[i] = side.data()[straddling[i]];
  clip_(cell, clipped_.values());
  bool isAnyEmpty = false;
  for (std::size_t i = 0; i < straddling.size(); ++i) {
    side.data()[straddling[i]] = clipped_.data()[i];
    isAnyEmpty |= clipped_.data()[i].bounds.isEmpty();
  }
  if (isAnyEmpty) {
    const auto removed = std::ranges::remove_if(
        side.values(), [](const Reference& r) { return r.bounds.isEmpty(); });
    side.resize(side.size() - removed.size());
  }
}

DividedReferences divideTogether(CellReferences cellReferences, const SplitPlane& plane,
                                 const Box3& cell, const BuildOptions& options,
                                 const ClipReferences& clip, MemoryMeter& memory) {
  const PlainArray<Reference>& references = cellReferences.references;
  const std::size_t batchCount = (references.size() + kBatchSize - 1) / kBatchSize;
  std::vector<ReferenceDivider> batches;
  batches.reserve(batchCount);
  for (std::size_t i = 0; i < batchCount; ++i)
    batches.emplace_back(options, clip);
  tbb::parallel_for(std::size_t{0}, batchCount, [&](std::size_t i) {
    const std::size_t begin = i * kBatchSize;
    const std::size_t count = std::min(kBatchSize, references.size() - begin);
    batches[i].divide(references.values().subspan(begin, count), plane, cell);
  });
  cellReferences = {};
  std::vector<std::size_t> firstLeft(batchCount + 1);
  std::vector<std::size_t> firstRight(batchCount + 1);
  for (std::size_t i = 0; i < batchCount; ++i) {
    firstLeft[i + 1] = firstLeft[i] + batches[i].left().size();
    firstRight[i + 1] = firstRight[i] + batches[i].right().size();
  }
  const MemoryCharge batchesCharge(memory,
                                   (firstLeft.back() + firstRight.back()) * sizeof(Reference));
  DividedReferences divided{.left = CellReferences(firstLeft.back(), memory),
                            .right = CellReferences(firstRight.back(), memory)};
  tbb::parallel_for(std::size_t{0}, batchCount, [&](std::size_t i) {
    std::ranges::copy(batches[i].left(), divided.left.references.data() + firstLeft[i]);
    std::ranges::copy(batches[i].right(), divided.right.references.data() + firstRight[i]);
  });
  return divided;
}

}  // namespace planetree::detail
