#pragma once

#include <cmath>
#include <concepts>
#include <limits>

namespace planetree {

/// The next representable number above `x`. Asking for hits from `nextUp(hit.t)` on finds the next
/// one behind a hit. Infinity and NaN are returned as they are.
template <std::floating_point T>
[[nodiscard]] T nextUp(T x) noexcept {
  return std::nextafter(x, std::numeric_limits<T>::infinity());
}

/// The next representable number below `x`.
template <std::floating_point T>
[[nodiscard]] T nextDown(T x) noexcept {
  return std::nextafter(x, -std::numeric_limits<T>::infinity());
}

/// The largest float that is not above `x`. NaN stays NaN.
[[nodiscard]] inline float roundDown(double x) noexcept {
  const auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest) > x ? nextDown(nearest) : nearest;
}

/// The smallest float that is not below `x`. NaN stays NaN.
[[nodiscard]] inline float roundUp(double x) noexcept {
  const auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest) < x ? nextUp(nearest) : nearest;
}

}  // namespace planetree
