#pragma once

#include <cstddef>
#include <cstdint>

namespace planetree::detail {

/// The bin of a position, from 0 to `lastBin`; whatever is rounded, a position never falls into a
/// lower bin than one below it. NaN, which an infinite number of bins makes of `lower`, becomes 0.
[[nodiscard]] inline std::size_t binOf(float position, float lower, float binsPerLength,
                                       float lastBin) noexcept {
  const float scaled = (position - lower) * binsPerLength;
  const float above = scaled > 0.0f ? scaled : 0.0f;
  return static_cast<std::size_t>(static_cast<std::int32_t>(above < lastBin ? above : lastBin));
}

}  // namespace planetree::detail
