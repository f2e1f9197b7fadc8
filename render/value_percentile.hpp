#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace planetree::render {

/// The value below which this fraction of the values lies; it reorders them. There must be one, and
/// none may be NaN. Linear in the values.
[[nodiscard]] inline float valuePercentile(std::vector<float>& values, double fraction) {
  const auto rank =
      static_cast<std::ptrdiff_t>(std::llround(fraction * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

/// The mean of the values. There must be one.
[[nodiscard]] inline double meanValue(const std::vector<float>& values) noexcept {
  double sum = 0.0;
  for (const float value : values)
    sum += static_cast<double>(value);
  return sum / static_cast<double>(values.size());
}

}  // namespace planetree::render
