#include "traversal/count_wide_steps.hpp"

#include "traversal/search_wide.hpp"

namespace planetree::detail {
namespace {

template <class Goal>
void countSteps(const TreeView<float>& tree, const Rayf& ray, WideSteps& steps) noexcept {
  if (tree.wide == nullptr)
    return;
  Hitf hit;
  const Request<float> request(tree, ray, ray.tMin, ray.tMax);
  WideSearch<Goal, float> search(request, hit);
  if (search.prepareRay())
    static_cast<void>(search.count(activeKernels(), steps));
}

}  // namespace

void countStepsToNearest(const TreeView<float>& tree, const Rayf& ray, WideSteps& steps) noexcept {
  countSteps<NearestHit>(tree, ray, steps);
}

void countStepsToAny(const TreeView<float>& tree, const Rayf& ray, WideSteps& steps) noexcept {
  countSteps<AnyHit>(tree, ray, steps);
}

}  // namespace planetree::detail
