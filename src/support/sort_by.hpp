#pragma once

#include <algorithm>
#include <utility>

namespace planetree::detail {

/// Sorts numbers by what `keyOf` says of them, and those with equal keys by themselves: the result
/// is the same everywhere.
template <class Numbers, class KeyOf>
void sortBy(Numbers& numbers, const KeyOf& keyOf) {
  std::sort(numbers.begin(), numbers.end(), [&](const auto& a, const auto& b) {
    return std::pair(keyOf(a), a) < std::pair(keyOf(b), b);
  });
}

}  // namespace planetree::detail
