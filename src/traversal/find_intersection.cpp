#include <planetree/traversal/find_intersection.hpp>

#include "traversal/offer_hits.hpp"
#include "traversal/search_tree.hpp"

#include <utility>

namespace planetree {
namespace {

template <class Goal, class T>
bool search(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options,
            StepCounts* steps, Hit<T>& hit) noexcept {
  if (detail::hasChoices(options)) {
    return Goal::kStopsAtAnyHit ? detail::findAnyChoice(tree, ray, options, steps)
                                : detail::findNearestChoice(tree, ray, options, steps, hit);
  }
  detail::Request<T> request(tree, ray, ray.tMin, ray.tMax);
  request.mask = options.mask;
  return detail::searchTree<Goal>(request, hit, steps);
}

}  // namespace

template <class T>
std::optional<Hit<T>> findIntersection(const TreeView<T>& tree, const Ray<T>& ray,
                                       const QueryOptions& options, StepCounts* steps) noexcept {
  // Made where the caller wants it, so that it is not copied.
  std::optional<Hit<T>> hit(std::in_place);
  if (!search<detail::NearestHit>(tree, ray, options, steps, *hit))
    hit.reset();
  return hit;
}

template <class T>
bool isOccluded(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options,
                StepCounts* steps) noexcept {
  Hit<T> unused;
  return search<detail::AnyHit>(tree, ray, options, steps, unused);
}

template std::optional<Hitf> findIntersection(const TreeView<float>&, const Rayf&,
                                              const QueryOptions&, StepCounts*) noexcept;
template std::optional<Hitd> findIntersection(const TreeView<double>&, const Rayd&,
                                              const QueryOptions&, StepCounts*) noexcept;
template bool isOccluded(const TreeView<float>&, const Rayf&, const QueryOptions&,
                         StepCounts*) noexcept;
template bool isOccluded(const TreeView<double>&, const Rayd&, const QueryOptions&,
                         StepCounts*) noexcept;

}  // namespace planetree
