#include "support/nearest_name.hpp"

#include <algorithm>
#include <numeric>

namespace planetree::detail {

std::optional<std::string> nearestName(std::string_view typed,
                                       const std::vector<std::string>& names) {
  std::optional<std::string> nearest;
  // Farther than that, a guess looks arbitrary.
  std::size_t smallest = typed.size() / 3 + 1;
  for (const std::string& name : names) {
    const bool isBeginning = typed.size() > 2 && name.starts_with(typed);
    const std::size_t distance = isBeginning ? 1 : editDistance(typed, name);
    if (distance < smallest) {
      smallest = distance;
      nearest = name;
    }
  }
  return nearest;
}

std::size_t editDistance(std::string_view a, std::string_view b) {
  // Rows of the table for the prefixes of `a`: the one before the last, the last, and this one.
  std::vector<std::size_t> beforeLast(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, changed});
      const bool isSwap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (isSwap)
        row[j] = std::min(row[j], beforeLast[j - 2] + 1);
    }
    beforeLast.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

}  // namespace planetree::detail
