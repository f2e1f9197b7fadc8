#include "split/plane_bins.hpp"

#include "isa/kernels.hpp"

#include <algorithm>

namespace planetree::detail {
namespace {

// In terms of the width of a bin: four roundings to float, each of half an ulp, move a position by
// less than 4 * 2^-24 * kMaxBinCount bins.
constexpr double kRoundingOfBins = 1.0 / 1024.0;

// Smaller cells are one bin along the axis: bins per length, or differences of positions where the
// processor flushes them to zero, could leave the range in which they are rounded like that.
constexpr float kSmallestBinnedSize = 0x1p-96f;

}  // namespace

BinScale::BinScale(const Box3& cell, std::size_t binCount) noexcept
    : binCount_(binCount), last_(static_cast<float>(binCount - 1)) {
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    lower_[a] = cell.lower[axis];
    const float size = cell.upper[axis] - cell.lower[axis];
    scale_[a] = size > kSmallestBinnedSize ? static_cast<float>(binCount) / size : 0.0f;
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
  static_assert(sizeof(Reference) == EndCounting::kLaneCount * sizeof(float));
  static_assert(sizeof(BinCounts) == EndCounting::kEndCount * kMaxBinCount * sizeof(std::uint32_t));
  EndCounting counting;
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    counting.lower[a] = counting.lower[a + 3] = scale.lower(axis);
    counting.scale[a] = counting.scale[a + 3] = scale.binsPerLength(axis);
  }
  counting.lastBin = scale.lastBin();
  counting.boxes = &references.data()->bounds.lower.x;
  counting.boxCount = references.size();
  counting.counts = lowerEnds.front().data();
  Counts others[EndCounting::kEndCount];
  for (Counts& counts : others)
    std::fill_n(counts.begin(), scale.binCount(), 0u);
  counting.otherCounts = others[0].data();
  activeKernels().countEnds(counting);
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t bin = 0; bin < scale.binCount(); ++bin) {
      lowerEnds[a][bin] += others[a][bin];
      upperEnds[a][bin] += others[a + 3][bin];
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
