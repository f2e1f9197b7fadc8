#include "traversal/offer_hits.hpp"

#include "traversal/search_wide.hpp"

#include <optional>
#include <type_traits>

namespace planetree::detail {

template <class Goal, class T>
bool offerHits(const Query<T>& query, StepCounts* steps) noexcept {
  Hit<T> unused;
  if constexpr (std::is_same_v<T, float>) {
    // Steps are those of the binary form.
    if (!steps) {
      if (const std::optional<bool> found = searchWide<Goal>(query, unused))
        return *found;
    }
  }
  const Node& root = query.tree.nodes.front();
  const Interval<T> part = query.partInsideTree();
  return steps ? traverse<Goal>(root, query, part, unused, Counting(*steps))
               : traverse<Goal>(root, query, part, unused, Unobserved{});
}

template <class T>
bool findNearestChoice(Query<T>& query, const HitChoices<T>& choices, StepCounts* steps,
                       Hit<T>& hit) noexcept {
  NearestSink<T> sink(choices, query.interval.tMax, hit);
  query.sink = &sink;
  return offerHits<NearestOffer>(query, steps);
}

template <class T>
bool findNearestChoice(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options,
                       StepCounts* steps, Hit<T>& hit) noexcept {
  Query<T> query(tree, ray, ray.tMin, ray.tMax);
  query.mask = options.mask;
  return findNearestChoice(query, {options, ray.direction}, steps, hit);
}

template <class T>
bool findAnyChoice(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options,
                   StepCounts* steps) noexcept {
  Query<T> query(tree, ray, ray.tMin, ray.tMax);
  query.mask = options.mask;
  const HitChoices<T> choices{options, ray.direction};
  AnySink<T> sink(choices, query.interval.tMax);
  query.sink = &sink;
  return offerHits<AnyOffer>(query, steps);
}

#define PLANETREE_INSTANTIATE(T)                                                                   \
  template bool offerHits<EveryOffer>(const Query<T>&, StepCounts*) noexcept;                      \
  template bool findNearestChoice(Query<T>&, const HitChoices<T>&, StepCounts*, Hit<T>&) noexcept; \
  template bool findNearestChoice(const TreeView<T>&, const Ray<T>&, const QueryOptions&,          \
                                  StepCounts*, Hit<T>&) noexcept;                                  \
  template bool findAnyChoice(const TreeView<T>&, const Ray<T>&, const QueryOptions&,              \
                              StepCounts*) noexcept;
PLANETREE_INSTANTIATE(float)
PLANETREE_INSTANTIATE(double)
#undef PLANETREE_INSTANTIATE

}  // namespace planetree::detail
