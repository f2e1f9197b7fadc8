#include "node/center_bins.hpp"

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
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    const float size = centers.upper[axis] - centers.lower[axis];
    lower_[a] = centers.lower[axis];
    scale_[a] = size > 0.0f ? static_cast<float>(kBinCount) / size : 0.0f;
  }
}

void CenterBins::Bin::add(const Bin& other) noexcept {
  extendBy(bounds, other.bounds);
  count += other.count;
}

std::size_t CenterBins::binOf(const Box3& box, Axis axis) const noexcept {
  const auto a = static_cast<std::size_t>(axis);
  const float scaled = (centerAlong(box, axis) - lower_[a]) * scale_[a];
  // Also right for NaN, which an infinite scale makes of the lowest center.
  const float above = scaled > 0.0f ? scaled : 0.0f;
  constexpr auto kLast = static_cast<float>(kBinCount - 1);
  return static_cast<std::size_t>(static_cast<std::int32_t>(above < kLast ? above : kLast));
}

std::optional<CenterBins::Cut> CenterBins::divide(std::span<const Box3> boxes, const Box3& centers,
                                                  std::span<std::uint32_t> places, double perTest) {
  scaleTo(centers);
  count(boxes, places);
  const Edge edge = findCheapestEdge(perTest);
  if (edge.bin == 0)
    return std::nullopt;
  // Each place is written to both sides, and stays where it belongs.
  right_.resize(places.size());
  std::size_t leftCount = 0;
  std::size_t rightCount = 0;
  for (const std::uint32_t place : places) {
    const bool isLeft = binOf(boxes[place], edge.axis) < edge.bin;
    right_[rightCount] = place;
    places[leftCount] = place;
    leftCount += isLeft ? 1 : 0;
    rightCount += isLeft ? 0 : 1;
  }
  std::copy_n(right_.begin(), rightCount, places.subspan(leftCount).begin());
  return Cut{.axis = edge.axis, .leftCount = leftCount};
}

void CenterBins::count(std::span<const Box3> boxes,
                       std::span<const std::uint32_t> places) noexcept {
  for (auto& bins : bins_)
    bins.fill({});
  for (const std::uint32_t place : places) {
    for (const Axis axis : kAxes) {
      Bin& bin = bins_[static_cast<std::size_t>(axis)][binOf(boxes[place], axis)];
      extendBy(bin.bounds, boxes[place]);
      ++bin.count;
    }
  }
}

CenterBins::Edge CenterBins::findCheapestEdge(double perTest) const noexcept {
  Edge cheapest;
  double leastCost = std::numeric_limits<double>::infinity();
  for (const Axis axis : kAxes) {
    const auto& bins = bins_[static_cast<std::size_t>(axis)];
    std::array<double, kBinCount> rightCosts = {};
    Bin right;
    for (std::size_t i = kBinCount; i-- > 1;) {
      right.add(bins[i]);
      rightCosts[i] = right.count > 0 ? costOf(right.bounds.surfaceArea(), right.count, perTest)
                                      : std::numeric_limits<double>::infinity();
    }
    Bin left;
    for (std::size_t i = 1; i < kBinCount; ++i) {
      left.add(bins[i - 1]);
      if (left.count == 0)
        continue;
      const double cost = costOf(left.bounds.surfaceArea(), left.count, perTest) + rightCosts[i];
      if (cost < leastCost) {
        leastCost = cost;
        cheapest = {.axis = axis, .bin = i};
      }
    }
  }
  return cheapest;
}

}  // namespace planetree::detail
