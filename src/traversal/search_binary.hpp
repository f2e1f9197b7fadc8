#pragma once

#include <planetree/hit/hit.hpp>
#include <planetree/traversal/step_counts.hpp>

#include "traversal/traverse.hpp"

namespace planetree::detail {

/// Answers a request through the binary form of the tree; adds to `steps` unless it is null. Behind
/// a call on purpose: what it needs on the stack is none of the business of the wide form.
template <class Goal, class T>
[[nodiscard]] bool searchBinary(const Request<T>& request, Hit<T>& hit, StepCounts* steps) noexcept;

}  // namespace planetree::detail
