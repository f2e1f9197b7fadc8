#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace planetree::detail {

/// Sorts numbers by what `keyOf` says of them, which is asked once for each, and those with equal
/// keys by themselves: the result is the same everywhere.
template <class Numbers, class KeyOf>
void sortBy(Numbers&& numbers, const KeyOf& keyOf) {
  using Number = typename std::remove_cvref_t<Numbers>::value_type;
  std::vector<std::pair<decltype(keyOf(numbers.front())), Number>> keyed;
  keyed.reserve(numbers.size());
  for (const Number number : numbers)
    keyed.emplace_back(keyOf(number), number);
  std::sort(keyed.begin(), keyed.end());
  for (std::size_t i = 0; i < keyed.size(); ++i)
    numbers[i] = keyed[i].second;
}

}  // namespace planetree::detail
