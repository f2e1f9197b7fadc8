// Counts the ends of boxes by bins. Compiled once for each instruction set; hence no include guard
// but the one of Highway.

#if defined(PLANETREE_COUNT_ENDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLANETREE_COUNT_ENDS_INL
#undef PLANETREE_COUNT_ENDS_INL
#else
#define PLANETREE_COUNT_ENDS_INL
#endif

#include "split/end_counting.hpp"

#include <hwy/highway.h>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace planetree::detail::HWY_NAMESPACE {

/// The six ends of a box are turned into bins at once; to count them is plain code. See
/// `binOf` (support/bin_of.hpp) for the order of the operations, which must be the same.
inline void countEnds(const EndCounting& counting) noexcept {
  namespace hn = hwy::HWY_NAMESPACE;
  constexpr std::size_t kLanes = HWY_MIN(EndCounting::kLaneCount, HWY_LANES(float));
  const hn::FixedTag<float, kLanes> floats;
  const hn::FixedTag<std::int32_t, kLanes> integers;
  const auto last = hn::Set(floats, counting.lastBin);
  HWY_ALIGN std::int32_t bins[2][EndCounting::kLaneCount];
  const float* box = counting.boxes;
  const auto findBins = [&](const float* from, std::int32_t* to) HWY_ATTR {
    for (std::size_t lane = 0; lane < EndCounting::kLaneCount; lane += kLanes) {
      // What is no end, but bits of something else, is cleared: as a float it might be denormal,
      // with which some processors take their time.
      const auto isEnd = hn::BitCast(floats, hn::Load(integers, counting.isEnd + lane));
      const auto position = hn::And(hn::LoadU(floats, from + lane), isEnd);
      const auto scaled = hn::Mul(hn::Sub(position, hn::Load(floats, counting.lower + lane)),
                                  hn::Load(floats, counting.scale + lane));
      const auto inside = hn::Min(hn::Max(scaled, hn::Zero(floats)), last);
      hn::Store(hn::ConvertTo(integers, inside), integers, to + lane);
    }
  };
  std::size_t i = 0;
  for (; i + 2 <= counting.boxCount; i += 2, box += 2 * EndCounting::kLaneCount) {
    findBins(box, bins[0]);
    findBins(box + EndCounting::kLaneCount, bins[1]);
    for (std::size_t end = 0; end < EndCounting::kEndCount; ++end) {
      ++counting.counts[end * EndCounting::kMaxBinCount + static_cast<std::size_t>(bins[0][end])];
      ++counting
            .otherCounts[end * EndCounting::kMaxBinCount + static_cast<std::size_t>(bins[1][end])];
    }
  }
  if (i < counting.boxCount) {
    findBins(box, bins[0]);
    for (std::size_t end = 0; end < EndCounting::kEndCount; ++end)
      ++counting.counts[end * EndCounting::kMaxBinCount + static_cast<std::size_t>(bins[0][end])];
  }
}

}  // namespace planetree::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
