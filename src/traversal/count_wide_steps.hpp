#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/traversal/tree_view.hpp>

#include "traversal/wide_query.hpp"

namespace planetree::detail {

/// What the wide form takes to find the nearest hit of a ray, or any, added to `steps`. Nothing for
/// rays beyond its range. For measurements: those of `StepCounts` are steps in the binary form.
void countStepsToNearest(const TreeView<float>& tree, const Rayf& ray, WideSteps& steps) noexcept;
void countStepsToAny(const TreeView<float>& tree, const Rayf& ray, WideSteps& steps) noexcept;

}  // namespace planetree::detail
