#pragma once

#include <cstddef>
#include <cstdint>

namespace planetree::detail {

/// What the kernels need to count the ends of boxes by bins. A box is eight words: the lower and
/// the upper corner, and two words more.
struct EndCounting {
  static constexpr std::size_t kLaneCount = 8;
  static constexpr std::size_t kEndCount = 6;
  static constexpr std::size_t kMaxBinCount = 256;

  alignas(64) float lower[kLaneCount] = {};  ///< of the cell, for each end
  alignas(64) float scale[kLaneCount] = {};  ///< bins per length, for each end
  alignas(64) std::int32_t isEnd[kLaneCount] = {-1, -1, -1, -1, -1, -1, 0, 0};
  float lastBin = 0.0f;
  const float* boxes = nullptr;
  std::size_t boxCount = 0;
  /// By end, `kMaxBinCount` each. The ends of every other box are counted in a place of their own:
  /// neighbours are often in the same bin, and to count one more there has to wait for the last.
  std::uint32_t* counts = nullptr;
  std::uint32_t* otherCounts = nullptr;
};

}  // namespace planetree::detail
