#include "traversal/offer_hits.hpp"

#include "traversal/search_tree.hpp"

namespace planetree::detail {

template <class Goal, class T>
bool offerHits(const Request<T>& request, StepCounts* steps) noexcept {
  Hit<T> unused;
  return searchTree<Goal>(request, unused, steps);
}

template <class T>
bool findNearestChoice(Request<T>& request, const HitChoices<T>& choices, StepCounts* steps,
                       Hit<T>& hit) noexcept {
  NearestSink<T> sink(choices, request.interval.tMax, hit);
  request.sink = &sink;
  return offerHits<NearestOffer>(request, steps);
}

template <class T>
bool findNearestChoice(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options,
                       StepCounts* steps, Hit<T>& hit) noexcept {
  Request<T> request(tree, ray, ray.tMin, ray.tMax);
  request.mask = options.mask;
  return findNearestChoice(request, {options, ray.direction}, steps, hit);
}

template <class T>
bool findAnyChoice(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options,
                   StepCounts* steps) noexcept {
  Request<T> request(tree, ray, ray.tMin, ray.tMax);
  request.mask = options.mask;
  const HitChoices<T> choices{options, ray.direction};
  AnySink<T> sink(choices, request.interval.tMax);
  request.sink = &sink;
  return offerHits<AnyOffer>(request, steps);
}

#define PLANETREE_INSTANTIATE(T)                                                          \
  template bool offerHits<EveryOffer>(const Request<T>&, StepCounts*) noexcept;           \
  template bool findNearestChoice(Request<T>&, const HitChoices<T>&, StepCounts*,         \
                                  Hit<T>&) noexcept;                                      \
  template bool findNearestChoice(const TreeView<T>&, const Ray<T>&, const QueryOptions&, \
                                  StepCounts*, Hit<T>&) noexcept;                         \
  template bool findAnyChoice(const TreeView<T>&, const Ray<T>&, const QueryOptions&,     \
                              StepCounts*) noexcept;
PLANETREE_INSTANTIATE(float)
PLANETREE_INSTANTIATE(double)
#undef PLANETREE_INSTANTIATE

}  // namespace planetree::detail
