#pragma once

#include <planetree/traversal/step_counts.hpp>

#include "traversal/search_wide.hpp"
#include "traversal/traverse.hpp"

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
  const Query<T> query(request);
  const Node& root = query.tree.nodes.front();
  const Interval<T> part = query.partInsideTree();
  return steps ? traverse<Goal>(root, query, part, hit, Counting(*steps))
               : traverse<Goal>(root, query, part, hit, Unobserved{});
}

}  // namespace planetree::detail
