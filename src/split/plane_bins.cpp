#include "split/plane_bins.hpp"

#include <algorithm>

namespace planetree::detail {
namespace {

// In terms of the width of a bin: three roundings to float, each of half an ulp, move a position by
// less than 3 * 2^-24 * kMaxBinCount bins.
constexpr double kRoundingOfBins = 1.0 / 1024.0;

}  // namespace

BinScale::BinScale(const Box3& cell, std::size_t binCount) noexcept
    : binCount_(binCount), last_(static_cast<float>(binCount - 1)) {
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    lower_[a] = cell.lower[axis];
    scale_[a] = static_cast<float>(binCount) / (cell.upper[axis] - cell.lower[axis]);
    size_[a] = static_cast<double>(cell.upper[axis]) - static_cast<double>(cell.lower[axis]);
  }
}

double BinScale::lowestIn(Axis axis, std::size_t bin) const noexcept {
  const double width = size_[static_cast<std::size_t>(axis)] / static_cast<double>(binCount_);
  return std::max(0.0, width * (static_cast<double>(bin) - kRoundingOfBins));
}

double BinScale::highestIn(Axis axis, std::size_t bin) const noexcept {
  const double size = size_[static_cast<std::size_t>(axis)];
  const double width = size / static_cast<double>(binCount_);
  return std::min(size, width * (static_cast<double>(bin + 1) + kRoundingOfBins));
}

void BinCounts::add(std::span<const Reference> references, const BinScale& scale) noexcept {
  for (const Reference& reference : references) {
    for (const Axis axis : kAxes) {
      const auto a = static_cast<std::size_t>(axis);
      ++lowerEnds[a][scale.binOf(axis, reference.bounds.lower[axis])];
      ++upperEnds[a][scale.binOf(axis, reference.bounds.upper[axis])];
    }
  }
}

void BinCounts::add(const BinCounts& other) noexcept {
  const auto addCounts = [](Counts& to, const Counts& from) {
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i] += from[i];
  };
  for (std::size_t a = 0; a < 3; ++a) {
    addCounts(lowerEnds[a], other.lowerEnds[a]);
    addCounts(upperEnds[a], other.upperEnds[a]);
  }
}

void BinCounts::clear(std::size_t binCount) noexcept {
  for (std::size_t a = 0; a < 3; ++a) {
    std::fill_n(lowerEnds[a].begin(), binCount, 0u);
    std::fill_n(upperEnds[a].begin(), binCount, 0u);
  }
}

}  // namespace planetree::detail
