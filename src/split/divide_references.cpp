#include "split/divide_references.hpp"

#include <planetree/split/find_best_split_plane.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace planetree::detail {
namespace {

// What one thread divides at a time.
constexpr std::size_t kBatchSize = 1u << 14u;
// What it divides in the nearest cache, before it goes to its place.
constexpr std::size_t kPieceSize = 1u << 10u;

void removeEmpty(PlainArray<Reference>& references) noexcept {
  const std::span<Reference> all = references.values();
  const auto end =
      std::remove_if(all.begin(), all.end(), [](const Reference& r) { return r.bounds.isEmpty(); });
  references.resize(static_cast<std::size_t>(end - all.begin()));
}

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
  if (isAnyEmpty)
    removeEmpty(side);
}

CellReferences ReferencePool::take(std::size_t count) {
  const std::lock_guard lock(mutex_);
  // The smallest of those that are large enough.
  auto best = free_.end();
  for (auto it = free_.begin(); it != free_.end(); ++it) {
    const std::size_t capacity = it->references.capacity();
    if (capacity >= count && (best == free_.end() || capacity < best->references.capacity()))
      best = it;
  }
  if (best == free_.end())
    return {count, memory_};
  CellReferences taken = std::move(*best);
  free_.erase(best);
  taken.references.resize(count);
  return taken;
}

void ReferencePool::giveBack(CellReferences references) {
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(references));
}

DividedReferences divideTogether(CellReferences cellReferences, const SplitPlane& plane,
                                 const Box3& cell, const BuildOptions& options,
                                 const ClipReferences& clip, ReferencePool& pool) {
  const std::span<const Reference> references = cellReferences.references.values();
  const std::size_t batchCount = (references.size() + kBatchSize - 1) / kBatchSize;
  const auto batchOf = [&](std::size_t i) {
    return references.subspan(i * kBatchSize,
                              std::min(kBatchSize, references.size() - i * kBatchSize));
  };
  // Where each batch goes to on both sides, so that the order stays.
  std::vector<std::size_t> firstLeft(batchCount + 1);
  std::vector<std::size_t> firstRight(batchCount + 1);
  tbb::parallel_for(std::size_t{0}, batchCount, [&](std::size_t i) {
    firstLeft[i + 1] = countLeftObjects(batchOf(i), plane, options.planarRule);
    firstRight[i + 1] = countRightObjects(batchOf(i), plane, options.planarRule);
  });
  std::partial_sum(firstLeft.begin(), firstLeft.end(), firstLeft.begin());
  std::partial_sum(firstRight.begin(), firstRight.end(), firstRight.begin());

  DividedReferences divided{.left = pool.take(firstLeft.back()),
                            .right = pool.take(firstRight.back())};
  const std::span<Reference> left = divided.left.references.values();
  const std::span<Reference> right = divided.right.references.values();
  std::atomic<bool> isAnyGone = false;
  tbb::parallel_for(std::size_t{0}, batchCount, [&](std::size_t i) {
    ReferenceDivider divider(options, clip);
    std::size_t leftEnd = firstLeft[i];
    std::size_t rightEnd = firstRight[i];
    for (auto rest = batchOf(i); !rest.empty();) {
      const auto piece = rest.first(std::min(kPieceSize, rest.size()));
      rest = rest.subspan(piece.size());
      divider.divide(piece, plane, cell);
      std::ranges::copy(divider.left(), left.begin() + static_cast<std::ptrdiff_t>(leftEnd));
      std::ranges::copy(divider.right(), right.begin() + static_cast<std::ptrdiff_t>(rightEnd));
      leftEnd += divider.left().size();
      rightEnd += divider.right().size();
    }
    // Clipping may leave nothing of an object on one side.
    if (leftEnd != firstLeft[i + 1] || rightEnd != firstRight[i + 1]) {
      std::ranges::fill(left.subspan(leftEnd, firstLeft[i + 1] - leftEnd), Reference());
      std::ranges::fill(right.subspan(rightEnd, firstRight[i + 1] - rightEnd), Reference());
      isAnyGone = true;
    }
  });
  if (isAnyGone) {
    removeEmpty(divided.left.references);
    removeEmpty(divided.right.references);
  }
  pool.giveBack(std::move(cellReferences));
  return divided;
}

}  // namespace planetree::detail
