#include <planetree/split/find_best_split_plane.hpp>

#include "support/assert.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace planetree {
namespace {

/// A sorted list of positions that the sweep passes one after the other.
class SortedPositions {
 public:
  void reserve(std::size_t count) { positions_.reserve(count); }
  // Adding zero turns -0 into +0: the plane must not depend on which of them came first.
  void add(float position) { positions_.push_back(position + 0.0f); }
  void sort() { std::sort(positions_.begin(), positions_.end()); }

  [[nodiscard]] std::size_t size() const noexcept { return positions_.size(); }
  [[nodiscard]] std::size_t passedCount() const noexcept { return passed_; }
  [[nodiscard]] std::size_t restCount() const noexcept { return positions_.size() - passed_; }
  [[nodiscard]] float next() const noexcept {
    return passed_ < positions_.size() ? positions_[passed_]
                                       : std::numeric_limits<float>::infinity();
  }
  /// Passes all entries at the position and returns how many there were.
  std::size_t passAll(float position) noexcept {
    const std::size_t before = passed_;
    while (passed_ < positions_.size() && positions_[passed_] == position)
      ++passed_;
    return passed_ - before;
  }

 private:
  std::vector<float> positions_;
  std::size_t passed_ = 0;
};

/// Sweeps a plane along one axis of a cell.
class Sweep {
 public:
  Sweep(std::span<const Reference> references, const Box3& cell, Axis axis,
        const BuildOptions& options)
      : cell_(cell), axis_(axis), options_(options), cellArea_(cell.surfaceArea()) {
    lowerEnds_.reserve(references.size());
    upperEnds_.reserve(references.size());
    for (const Reference& reference : references) {
      if (!reference.isPlanar(axis)) {
        lowerEnds_.add(reference.bounds.lower[axis]);
        upperEnds_.add(reference.bounds.upper[axis]);
      } else {
        (reference.belongsLeft(axis) ? leftPlanars_ : rightPlanars_)
            .add(reference.bounds.lower[axis]);
      }
    }
    for (SortedPositions* positions : {&lowerEnds_, &upperEnds_, &leftPlanars_, &rightPlanars_}) {
      positions->sort();
    }
  }

  /// Lowers `best` to the cheapest plane of this axis, if that is cheaper.
  void improve(std::optional<SplitPlane>& best) {
    while (true) {
      const float position = std::min(
          {lowerEnds_.next(), upperEnds_.next(), leftPlanars_.next(), rightPlanars_.next()});
      if (position == std::numeric_limits<float>::infinity())
        return;
      // What begins or lies before the plane has a part on the left; what ends behind it or lies
      // behind it, on the right. What ends at the plane has no part on the right, and what begins
      // at it none on the left.
      const std::size_t leftCount =
          lowerEnds_.passedCount() + leftPlanars_.passedCount() + rightPlanars_.passedCount();
      const std::size_t leftPlanarCount = leftPlanars_.passAll(position);
      const std::size_t rightPlanarCount = rightPlanars_.passAll(position);
      upperEnds_.passAll(position);
      const std::size_t rightCount =
          upperEnds_.restCount() + leftPlanars_.restCount() + rightPlanars_.restCount();
      lowerEnds_.passAll(position);
      if (isInsideCell(position)) {
        tryPlane(position, leftCount, leftPlanarCount, rightPlanarCount, rightCount, best);
      }
    }
  }

 private:
  [[nodiscard]] bool isInsideCell(float position) const noexcept {
    const float lower = cell_.lower[axis_];
    const float upper = cell_.upper[axis_];
    return options_.allowsEmptyCells ? position > lower && position < upper
                                     : position >= lower && position <= upper;
  }

  void tryPlane(float position, std::size_t leftCount, std::size_t leftPlanarCount,
                std::size_t rightPlanarCount, std::size_t rightCount,
                std::optional<SplitPlane>& best) const {
    if (options_.planarRule == PlanarRule::NormalSign) {
      tryCounts(position, leftCount + leftPlanarCount, rightCount + rightPlanarCount, Side::Right,
                best);
      return;
    }
    const std::size_t planarCount = leftPlanarCount + rightPlanarCount;
    tryCounts(position, leftCount, rightCount + planarCount, Side::Right, best);
    if (planarCount > 0) {
      tryCounts(position, leftCount + planarCount, rightCount, Side::Left, best);
    }
  }

  void tryCounts(float position, std::size_t leftCount, std::size_t rightCount, Side planarSide,
                 std::optional<SplitPlane>& best) const {
    SplitPlane plane{.axis = axis_,
                     .position = position,
                     .leftCount = leftCount,
                     .rightCount = rightCount,
                     .planarSide = planarSide};
    plane.cost = options_.cost.splitCost(
        plane.leftCount, calculateLeftBBox(plane, cell_).surfaceArea(), plane.rightCount,
        calculateRightBBox(plane, cell_).surfaceArea(), cellArea_);
    if (!best || plane.cost < best->cost)
      best = plane;
  }

  const Box3& cell_;
  Axis axis_;
  const BuildOptions& options_;
  double cellArea_;
  SortedPositions lowerEnds_;
  SortedPositions upperEnds_;
  SortedPositions leftPlanars_;   ///< in a plane, and to the left of it by the sign of the normal
  SortedPositions rightPlanars_;  ///< in a plane, and to the right of it by the sign of the normal
};

[[nodiscard]] bool planarGoesLeft(const Reference& reference, const SplitPlane& plane,
                                  PlanarRule rule) noexcept {
  return rule == PlanarRule::NormalSign ? reference.belongsLeft(plane.axis)
                                        : plane.planarSide == Side::Left;
}

[[nodiscard]] bool liesIn(const SplitPlane& plane, const Reference& reference) noexcept {
  return reference.isPlanar(plane.axis) && reference.bounds.lower[plane.axis] == plane.position;
}

}  // namespace

std::optional<SplitPlane> findBestSplitPlane(std::span<const Reference> references,
                                             const Box3& cell, const BuildOptions& options) {
  std::optional<SplitPlane> best;
  for (const Axis axis : kAxes)
    Sweep(references, cell, axis, options).improve(best);
  PLANETREE_ASSERT(!best ||
                   best->leftCount == countLeftObjects(references, *best, options.planarRule));
  PLANETREE_ASSERT(!best ||
                   best->rightCount == countRightObjects(references, *best, options.planarRule));
  return best;
}

bool goesLeft(const Reference& reference, const SplitPlane& plane, PlanarRule rule) noexcept {
  if (liesIn(plane, reference))
    return planarGoesLeft(reference, plane, rule);
  return reference.bounds.lower[plane.axis] < plane.position;
}

bool goesRight(const Reference& reference, const SplitPlane& plane, PlanarRule rule) noexcept {
  if (liesIn(plane, reference))
    return !planarGoesLeft(reference, plane, rule);
  return reference.bounds.upper[plane.axis] > plane.position;
}

std::uint64_t countLeftObjects(std::span<const Reference> references, const SplitPlane& plane,
                               PlanarRule rule) noexcept {
  return static_cast<std::uint64_t>(
      std::count_if(references.begin(), references.end(),
                    [&](const Reference& r) { return goesLeft(r, plane, rule); }));
}

std::uint64_t countRightObjects(std::span<const Reference> references, const SplitPlane& plane,
                                PlanarRule rule) noexcept {
  return static_cast<std::uint64_t>(
      std::count_if(references.begin(), references.end(),
                    [&](const Reference& r) { return goesRight(r, plane, rule); }));
}

}  // namespace planetree
