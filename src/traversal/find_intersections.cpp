#include <planetree/traversal/find_intersections.hpp>

#include "traversal/offer_hits.hpp"

namespace planetree {
namespace {

/// The request for what is behind a hit, and what tells it from the hits at the same t before it.
template <class T>
struct QueryBehind {
  detail::Request<T> request;
  detail::HitChoices<T> choices;

  QueryBehind(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options) noexcept
      : request(tree, ray, ray.tMin, ray.tMax), choices{options, ray.direction} {
    request.mask = options.mask;
  }
  QueryBehind(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options,
              const Hit<T>& after) noexcept
      : QueryBehind(tree, ray, options) {
    choices.after = after;
    // A NaN stays, on either side.
    if (!(after.t <= ray.tMin) && ray.tMin == ray.tMin)
      request.interval.tMin = after.t;
  }
};

template <class T>
FoundHits fill(QueryBehind<T>& behind, std::span<Hit<T>> hits, StepCounts* steps) noexcept {
  detail::ListSink<T> sink(behind.choices, behind.request.interval.tMax, hits);
  behind.request.sink = &sink;
  detail::offerHits<detail::EveryOffer>(behind.request, steps);
  return {.count = sink.count(), .hasMore = sink.hasMore()};
}

}  // namespace

template <class T>
FoundHits findIntersections(const TreeView<T>& tree, const Ray<T>& ray, std::span<Hit<T>> hits,
                            const QueryOptions& options, StepCounts* steps) noexcept {
  QueryBehind<T> behind(tree, ray, options);
  return fill(behind, hits, steps);
}

template <class T>
FoundHits findNextIntersections(const TreeView<T>& tree, const Ray<T>& ray, const Hit<T>& after,
                                std::span<Hit<T>> hits, const QueryOptions& options,
                                StepCounts* steps) noexcept {
  QueryBehind<T> behind(tree, ray, options, after);
  return fill(behind, hits, steps);
}

template <class T>
std::optional<Hit<T>> findNextIntersection(const TreeView<T>& tree, const Ray<T>& ray,
                                           const Hit<T>& after, const QueryOptions& options,
                                           StepCounts* steps) noexcept {
  QueryBehind<T> behind(tree, ray, options, after);
  Hit<T> hit;
  if (!detail::findNearestChoice(behind.request, behind.choices, steps, hit))
    return std::nullopt;
  return hit;
}

#define PLANETREE_INSTANTIATE(T)                                                             \
  template FoundHits findIntersections(const TreeView<T>&, const Ray<T>&, std::span<Hit<T>>, \
                                       const QueryOptions&, StepCounts*) noexcept;           \
  template FoundHits findNextIntersections(const TreeView<T>&, const Ray<T>&, const Hit<T>&, \
                                           std::span<Hit<T>>, const QueryOptions&,           \
                                           StepCounts*) noexcept;                            \
  template std::optional<Hit<T>> findNextIntersection(const TreeView<T>&, const Ray<T>&,     \
                                                      const Hit<T>&, const QueryOptions&,    \
                                                      StepCounts*) noexcept;
PLANETREE_INSTANTIATE(float)
PLANETREE_INSTANTIATE(double)
#undef PLANETREE_INSTANTIATE

}  // namespace planetree
