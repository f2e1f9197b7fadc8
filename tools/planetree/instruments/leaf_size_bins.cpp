#include "instruments/leaf_size_bins.hpp"

#include "talk.hpp"

#include <fmt/format.h>

namespace planetree::tool {

namespace {

constexpr std::uint64_t kMostSingleSizes = 24;
constexpr std::uint64_t kFirstRange = 8;

std::vector<LeafSizeBin> emptyBins(std::uint64_t largest) {
  const std::uint64_t singleCount = largest < kMostSingleSizes ? largest + 1 : kFirstRange;
  std::vector<LeafSizeBin> bins;
  for (std::uint64_t size = 0; size < singleCount; ++size)
    bins.push_back({size, size, 0});
  for (std::uint64_t size = singleCount; size <= largest; size *= 2)
    bins.push_back({size, 2 * size - 1, 0});
  return bins;
}

}  // namespace

std::vector<LeafSizeBin> leafSizeBins(std::span<const LeafSizeCount> sizes) {
  if (sizes.empty())
    return {};
  std::vector<LeafSizeBin> bins = emptyBins(sizes.back().objectCount);
  std::size_t bin = 0;
  for (const LeafSizeCount& size : sizes) {
    while (bins[bin].highest < size.objectCount)
      ++bin;
    bins[bin].leafCount += size.leafCount;
  }
  return bins;
}

std::string sizeText(const LeafSizeBin& bin) {
  return bin.isRange() ? fmt::format("{}–{}", grouped(bin.lowest), grouped(bin.highest))
                       : grouped(bin.lowest);
}

}  // namespace planetree::tool
