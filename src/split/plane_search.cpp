#include "split/plane_search.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <limits>

namespace planetree::detail {
namespace {

// From here on several threads look at the references of one cell.
constexpr std::size_t kParallelThreshold = 1u << 16u;
constexpr std::size_t kGrainSize = 1u << 14u;
constexpr std::size_t kPieceSize = 1u << 10u;

// Costs of bins are computed in another order than those of planes. What rounding makes of that is
// far below this part of them.
constexpr double kRoundingOfCosts = 1e-9;

enum class EventKind : std::uint8_t { LowerEnd, UpperEnd, LeftPlanar, RightPlanar };

std::uint64_t eventOf(float position, EventKind kind) noexcept {
  return std::uint64_t{orderedBits(position)} << 32u | static_cast<std::uint64_t>(kind);
}
EventKind kindOf(std::uint64_t event) noexcept {
  return static_cast<EventKind>(event & 0xFFFF'FFFFu);
}
std::uint32_t placeOf(std::uint64_t event) noexcept {
  return static_cast<std::uint32_t>(event >> 32u);
}

/// More bins leave fewer ends to be sorted, and cost more themselves.
std::size_t binCountFor(std::size_t referenceCount) noexcept {
  if (referenceCount < 16)
    return 1;
  if (referenceCount < 256)
    return 16;
  if (referenceCount < 2048)
    return 32;
  return referenceCount < 16384 ? 64 : BinCounts::kMaxBinCount;
}

/// Keeps the cheapest plane of those that are tried.
class PlaneTrial {
 public:
  PlaneTrial(const BuildOptions& options, const Box3& cell, double cellArea, Axis axis,
             std::optional<SplitPlane>& best)
      : options_(options), cell_(cell), cellArea_(cellArea), axis_(axis), best_(best) {}

  void tryPlane(float position, std::size_t leftCount, std::size_t leftPlanarCount,
                std::size_t rightPlanarCount, std::size_t rightCount) const {
    if (!isInsideCell(position))
      return;
    if (options_.planarRule == PlanarRule::NormalSign) {
      tryCounts(position, leftCount + leftPlanarCount, rightCount + rightPlanarCount, Side::Right);
      return;
    }
    const std::size_t planarCount = leftPlanarCount + rightPlanarCount;
    tryCounts(position, leftCount, rightCount + planarCount, Side::Right);
    if (planarCount > 0)
      tryCounts(position, leftCount + planarCount, rightCount, Side::Left);
  }

 private:
  [[nodiscard]] bool isInsideCell(float position) const noexcept {
    const float lower = cell_.lower[axis_];
    const float upper = cell_.upper[axis_];
    return options_.allowsEmptyCells ? position > lower && position < upper
                                     : position >= lower && position <= upper;
  }

  void tryCounts(float position, std::size_t leftCount, std::size_t rightCount,
                 Side planarSide) const {
    SplitPlane plane{.axis = axis_,
                     .position = position,
                     .leftCount = leftCount,
                     .rightCount = rightCount,
                     .planarSide = planarSide};
    plane.cost = options_.cost.splitCost(
        plane.leftCount, calculateLeftBBox(plane, cell_).surfaceArea(), plane.rightCount,
        calculateRightBBox(plane, cell_).surfaceArea(), cellArea_);
    if (!best_ || plane.cost < best_->cost)
      best_ = plane;
  }

  const BuildOptions& options_;
  const Box3& cell_;
  double cellArea_;
  Axis axis_;
  std::optional<SplitPlane>& best_;
};

}  // namespace

std::optional<SplitPlane> PlaneSearch::find(std::span<const Reference> references, const Box3& cell,
                                            double limit) {
  if (options_.cost.traversalCost * (1.0 - options_.cost.emptyBonus) >= limit)
    return std::nullopt;
  const BinScale scale(cell, binCountFor(references.size()));
  prepareCosts(cell);
  double bound = limit;
  if (scale.binCount() > 1) {
    count(references, scale);
    sumUp(scale.binCount());
    if (options_.exactPlanes) {
      bound = std::min(bound, cheapestEdge(scale, Edges::WithPlanes).cost);
    } else if (const auto found = searchAtBestEdge(references, cell, scale)) {
      return found->cost < limit ? found : std::nullopt;
    }
  }
  // A plane at an edge between bins is no candidate, but hardly cheaper than the best of them. If
  // it is, all bins that are no dearer than what was found have to be opened after all.
  while (openBins(scale, bound)) {
    const std::optional<SplitPlane> best = searchOpenBins(references, cell, scale);
    const double found = best ? best->cost : std::numeric_limits<double>::infinity();
    if (found <= bound)
      return found < limit ? best : std::nullopt;
    if (bound >= limit)
      return std::nullopt;
    bound = std::min(found, limit);
  }
  return std::nullopt;
}

std::optional<SplitPlane> PlaneSearch::searchAtBestEdge(std::span<const Reference> references,
                                                        const Box3& cell, const BinScale& scale) {
  for (const Edges edges : {Edges::All, Edges::WithPlanes}) {
    const Edge edge = cheapestEdge(scale, edges);
    if (edge.bin == 0)
      break;
    openBinsAt(edge, scale);
    if (const std::optional<SplitPlane> best = searchOpenBins(references, cell, scale))
      return best;
  }
  return std::nullopt;
}

std::optional<SplitPlane> PlaneSearch::searchOpenBins(std::span<const Reference> references,
                                                      const Box3& cell, const BinScale& scale) {
  gather(references, scale);
  std::optional<SplitPlane> best;
  for (const Axis axis : kAxes)
    sweep(axis, cell, scale, best);
  return best;
}

void PlaneSearch::count(std::span<const Reference> references, const BinScale& scale) {
  counts_.clear(scale.binCount());
  if (references.size() < kParallelThreshold) {
    counts_.add(references, scale);
    return;
  }
  counts_ = tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, references.size(), kGrainSize), BinCounts(),
      [&](const tbb::blocked_range<std::size_t>& range, BinCounts counts) {
        counts.add(references.subspan(range.begin(), range.size()), scale);
        return counts;
      },
      [](BinCounts a, const BinCounts& b) {
        a.add(b);
        return a;
      });
}

void PlaneSearch::sumUp(std::size_t binCount) noexcept {
  for (std::size_t a = 0; a < 3; ++a) {
    std::uint32_t sum = 0;
    for (std::size_t bin = 0; bin < binCount; ++bin) {
      lowerEndsBefore_[a][bin] = sum;
      sum += counts_.lowerEnds[a][bin];
    }
    lowerEndsBefore_[a][binCount] = sum;
    sum = 0;
    upperEndsFrom_[a][binCount] = 0;
    for (std::size_t bin = binCount; bin-- > 0;) {
      sum += counts_.upperEnds[a][bin];
      upperEndsFrom_[a][bin] = sum;
    }
  }
}

void PlaneSearch::prepareCosts(const Box3& cell) noexcept {
  cellArea_ = cell.surfaceArea();
  for (const Axis axis : kAxes) {
    const auto sizeAlong = [&](Axis of) {
      return static_cast<double>(cell.upper[of]) - static_cast<double>(cell.lower[of]);
    };
    const double second = sizeAlong(nextAxis(axis));
    const double third = sizeAlong(nextAxis(nextAxis(axis)));
    AxisCost& cost = costs_[static_cast<std::size_t>(axis)];
    cost.size = sizeAlong(axis);
    const double perObject = options_.cost.intersectionCost;
    cost.constant = perObject * (cellArea_ > 0.0 ? 2.0 * second * third / cellArea_ : 1.0);
    cost.slope = perObject * (cellArea_ > 0.0 ? 2.0 * (second + third) / cellArea_ : 0.0);
  }
}

double PlaneSearch::costOf(std::size_t axis, double distance, double leftCount,
                           double rightCount) const noexcept {
  const AxisCost& cost = costs_[axis];
  const double objectCost = leftCount * (cost.constant + cost.slope * distance) +
                            rightCount * (cost.constant + cost.slope * (cost.size - distance));
  const bool cutsOffEmptySpace = leftCount == 0.0 || rightCount == 0.0;
  return (options_.cost.traversalCost + objectCost) *
         (cutsOffEmptySpace ? 1.0 - options_.cost.emptyBonus : 1.0);
}

PlaneSearch::Edge PlaneSearch::cheapestEdge(const BinScale& scale, Edges edges) const noexcept {
  Edge cheapest;
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    const double width = costs_[a].size / static_cast<double>(scale.binCount());
    const std::size_t last = scale.binCount() - 1;
    const bool liesAtAWall = upperEndsFrom_[a][1] == 0 || lowerEndsBefore_[a][last] == 0;
    if (liesAtAWall && edges == Edges::WithPlanes)
      continue;
    for (std::size_t bin = 1; bin < scale.binCount(); ++bin) {
      const double cost = costOf(a, width * static_cast<double>(bin), lowerEndsBefore_[a][bin],
                                 upperEndsFrom_[a][bin]);
      if (cost < cheapest.cost)
        cheapest = {.cost = cost, .axis = axis, .bin = bin};
    }
  }
  return cheapest;
}

void PlaneSearch::openBinsAt(const Edge& edge, const BinScale& scale) noexcept {
  for (auto& isOpen : isOpen_)
    std::fill_n(isOpen.begin(), scale.binCount(), false);
  const auto a = static_cast<std::size_t>(edge.axis);
  const auto isEmpty = [&](std::size_t bin) {
    return counts_.lowerEnds[a][bin] == 0 && counts_.upperEnds[a][bin] == 0;
  };
  std::size_t first = edge.bin;
  while (first > 0 && isEmpty(--first)) {
  }
  std::size_t last = edge.bin;
  while (last + 1 < scale.binCount() && isEmpty(last))
    ++last;
  std::fill(isOpen_[a].begin() + static_cast<std::ptrdiff_t>(first),
            isOpen_[a].begin() + static_cast<std::ptrdiff_t>(last) + 1, true);
}

bool PlaneSearch::openBins(const BinScale& scale, double cost) noexcept {
  bool isAnyOpen = false;
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    if (scale.binCount() == 1) {
      isOpen_[a][0] = true;
      lowerEndsBefore_[a][0] = 0;
      isAnyOpen = true;
      continue;
    }
    for (std::size_t bin = 0; bin < scale.binCount(); ++bin) {
      // Within a bin there are at least so many on each side. With these counts the cost is linear
      // in the position, and thus lowest at one of the two edges.
      const double leftCount = lowerEndsBefore_[a][bin];
      const double rightCount = upperEndsFrom_[a][bin + 1];
      const double least = std::min(costOf(a, scale.lowestIn(axis, bin), leftCount, rightCount),
                                    costOf(a, scale.highestIn(axis, bin), leftCount, rightCount));
      isOpen_[a][bin] = least * (1.0 - kRoundingOfCosts) <= cost;
      isAnyOpen |= isOpen_[a][bin];
    }
  }
  return isAnyOpen;
}

void PlaneSearch::gather(std::span<const Reference> references, const BinScale& scale) {
  for (EventList& list : events_)
    list.count = 0;
  if (scale.binCount() == 1) {
    for (std::size_t a = 0; a < 3; ++a)
      upperEndsFrom_[a][0] = static_cast<std::uint32_t>(references.size());
  }
  if (references.size() < kParallelThreshold) {
    gatherInto(events_, references, scale);
    for (std::size_t a = 0; a < 3; ++a)
      sorters_[a].sort(events_[a].events());
    return;
  }
  tbb::enumerable_thread_specific<Events> gathered;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, references.size(), kGrainSize),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      gatherInto(gathered.local(), references.subspan(range.begin(), range.size()),
                                 scale);
                    });
  tbb::parallel_for(std::size_t{0}, events_.size(), [&](std::size_t a) {
    EventList& all = events_[a];
    for (Events& part : gathered) {
      const std::span<const Event> events = part[a].events();
      const std::size_t before = all.count;
      all.count += events.size();
      all.room.resize(std::max(all.room.size(), all.count));
      std::ranges::copy(events, all.room.data() + before);
    }
    sorters_[a].sort(all.events());
  });
}

void PlaneSearch::gatherInto(Events& events, std::span<const Reference> references,
                             const BinScale& scale) const {
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    const auto& isOpen = isOpen_[a];
    if (std::none_of(isOpen.begin(), isOpen.begin() + scale.binCount(),
                     [](bool open) { return open; })) {
      continue;
    }
    // Few of the ends of large cells are events: there is room for all ends of one piece.
    EventList& list = events[a];
    for (std::size_t begin = 0; begin < references.size(); begin += kPieceSize) {
      const auto piece = references.subspan(begin, std::min(kPieceSize, references.size() - begin));
      // One more than there are ends, since each is written before it is known to be an event.
      list.room.resize(std::max(list.room.size(), list.count + 2 * piece.size() + 1));
      Event* end = list.room.data() + list.count;
      for (const Reference& reference : piece) {
        const float lower = reference.bounds.lower[axis];
        const float upper = reference.bounds.upper[axis];
        const bool isPlanar = lower == upper;
        const EventKind lowerKind = !isPlanar                     ? EventKind::LowerEnd
                                    : reference.belongsLeft(axis) ? EventKind::LeftPlanar
                                                                  : EventKind::RightPlanar;
        *end = eventOf(lower, lowerKind);
        end += isOpen[scale.binOf(axis, lower)] ? 1 : 0;
        *end = eventOf(upper, EventKind::UpperEnd);
        end += !isPlanar && isOpen[scale.binOf(axis, upper)] ? 1 : 0;
      }
      list.count = static_cast<std::size_t>(end - list.room.data());
    }
  }
}

void PlaneSearch::sweep(Axis axis, const Box3& cell, const BinScale& scale,
                        std::optional<SplitPlane>& best) {
  const auto a = static_cast<std::size_t>(axis);
  const PlaneTrial trial(options_, cell, cellArea_, axis, best);
  const std::span<const Event> events = events_[a].events();
  // What begins or lies before the plane has a part on the left; what ends behind it or lies behind
  // it, on the right. What ends at the plane has no part on the right, and what begins at it none
  // on the left.
  std::size_t endOfOpenBins = 0;
  std::size_t leftCount = 0;
  std::size_t rightCount = 0;
  for (std::size_t i = 0; i < events.size();) {
    const float position = fromOrderedBits(placeOf(events[i]));
    std::size_t bin = scale.binOf(axis, position);
    if (bin >= endOfOpenBins) {
      // Where the row of open bins ends, what lies up to the next one is counted by its bins.
      while (bin > endOfOpenBins && isOpen_[a][bin - 1])
        --bin;
      leftCount = lowerEndsBefore_[a][bin];
      rightCount = upperEndsFrom_[a][bin];
      while (bin < scale.binCount() && isOpen_[a][bin])
        ++bin;
      endOfOpenBins = bin;
    }
    std::array<std::size_t, 4> counts = {};
    const std::uint32_t place = placeOf(events[i]);
    for (; i < events.size() && placeOf(events[i]) == place; ++i)
      ++counts[static_cast<std::size_t>(kindOf(events[i]))];
    const std::size_t leftPlanarCount = counts[static_cast<std::size_t>(EventKind::LeftPlanar)];
    const std::size_t rightPlanarCount = counts[static_cast<std::size_t>(EventKind::RightPlanar)];
    const std::size_t planarCount = leftPlanarCount + rightPlanarCount;
    rightCount -= counts[static_cast<std::size_t>(EventKind::UpperEnd)] + planarCount;
    trial.tryPlane(position, leftCount, leftPlanarCount, rightPlanarCount, rightCount);
    leftCount += counts[static_cast<std::size_t>(EventKind::LowerEnd)] + planarCount;
  }
}

}  // namespace planetree::detail
