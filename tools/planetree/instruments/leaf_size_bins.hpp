#pragma once

#include <planetree/node/tree_statistics.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace planetree::tool {

/// How many leaves hold so many objects.
struct LeafSizeBin {
  std::uint64_t lowest = 0;   ///< objects
  std::uint64_t highest = 0;  ///< objects
  std::uint64_t leafCount = 0;

  [[nodiscard]] bool isRange() const noexcept { return lowest != highest; }
};

/// All sizes from 0 to the largest, each on its own if that makes a readable chart; else the larger
/// ones in ranges, each twice as wide as the one before it.
[[nodiscard]] std::vector<LeafSizeBin> leafSizeBins(std::span<const LeafSizeCount> sizes);

/// "7", or "8–15" with a dash.
[[nodiscard]] std::string sizeText(const LeafSizeBin& bin);

}  // namespace planetree::tool
