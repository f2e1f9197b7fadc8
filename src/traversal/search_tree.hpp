#pragma once

#include <planetree/traversal/step_counts.hpp>

#include "traversal/search_binary.hpp"
#include "traversal/search_wide.hpp"

#include <optional>

namespace planetree::detail {

/// Answers a request through the form of the tree that is fastest. The hit is put into `hit`, or
/// offered to the sink of the request, as the goal has it. Returns whether there was one.
template <class Goal, class T>
[[nodiscard]] bool searchTree(const Request<T>& request, Hit<T>& hit, StepCounts* steps) noexcept {
  // Steps are those of the binary form.
  if (!steps) {
    if (const std::optional<bool> found = searchWide<Goal>(request, hit))
      return *found;
  }
  return searchBinary<Goal>(request, hit, steps);
}

}  // namespace planetree::detail
