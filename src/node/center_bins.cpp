#include "node/center_bins.hpp"

#include "support/bin_of.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planetree::detail {
namespace {

/// Without a branch for boxes without anything in them: these are default-made, and change nothing.
void extendBy(Box3& bounds, const Box3& box) noexcept {
  for (const Axis axis : kAxes) {
    bounds.lower[axis] = std::min(bounds.lower[axis], box.lower[axis]);
    bounds.upper[axis] = std::max(bounds.upper[axis], box.upper[axis]);
  }
}

double costOf(double area, std::uint32_t count, double perTest) noexcept {
  return area * std::ceil(count / perTest);
}

}  // namespace

void CenterBins::scaleTo(const Box3& centers) noexcept {
  axis_ = longestAxis(centers);
  const float size = centers.upper[axis_] - centers.lower[axis_];
  lower_ = centers.lower[axis_];
  scale_ = size > 0.0f ? static_cast<float>(kBinCount) / size : 0.0f;
}

void CenterBins::Bin::add(const Bin& other) noexcept {
  extendBy(bounds, other.bounds);
  count += other.count;
}

std::size_t CenterBins::binOf(const Box3& box) const noexcept {
  constexpr auto kLast = static_cast<float>(kBinCount - 1);
  return detail::binOf(centerAlong(box, axis_), lower_, scale_, kLast);
}

std::optional<CenterBins::Cut> CenterBins::divide(std::span<const Box3> boxes, const Box3& centers,
                                                  std::span<std::uint32_t> places, double perTest) {
  scaleTo(centers);
  count(boxes, places);
  const std::size_t edge = findCheapestEdge(perTest);
  if (edge == 0)
    return std::nullopt;
  // Each place is written to both sides, and stays where it belongs.
  right_.resize(places.size());
  std::size_t leftCount = 0;
  std::size_t rightCount = 0;
  for (const std::uint32_t place : places) {
    const bool isLeft = binOf(boxes[place]) < edge;
    right_[rightCount] = place;
    places[leftCount] = place;
    leftCount += isLeft ? 1 : 0;
    rightCount += isLeft ? 0 : 1;
  }
  std::copy_n(right_.begin(), rightCount, places.subspan(leftCount).begin());
  return Cut{.axis = axis_, .leftCount = leftCount};
}

void CenterBins::count(std::span<const Box3> boxes,
                       std::span<const std::uint32_t> places) noexcept {
  bins_.fill({});
  for (const std::uint32_t place : places) {
    Bin& bin = bins_[binOf(boxes[place])];
    extendBy(bin.bounds, boxes[place]);
    ++bin.count;
  }
}

std::size_t CenterBins::findCheapestEdge(double perTest) const noexcept {
  std::array<double, kBinCount> rightCosts = {};
  Bin right;
  for (std::size_t i = kBinCount; i-- > 1;) {
    right.add(bins_[i]);
    rightCosts[i] = right.count > 0 ? costOf(right.bounds.surfaceArea(), right.count, perTest)
                                    : std::numeric_limits<double>::infinity();
  }
  std::size_t cheapest = 0;
  double leastCost = std::numeric_limits<double>::infinity();
  Bin left;
  for (std::size_t i = 1; i < kBinCount; ++i) {
    left.add(bins_[i - 1]);
    if (left.count == 0)
      continue;
    const double cost = costOf(left.bounds.surfaceArea(), left.count, perTest) + rightCosts[i];
    if (cost < leastCost) {
      leastCost = cost;
      cheapest = i;
    }
  }
  return cheapest;
}

}  // namespace planetree::detail
