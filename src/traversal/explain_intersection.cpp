#include <planetree/traversal/explain_intersection.hpp>

#include "traversal/hit_choices.hpp"
#include "traversal/traverse.hpp"
#include "traversal/walk_recorder.hpp"

#include "support/assert.hpp"

namespace planetree {
namespace {

template <class T>
Walk<T> explain(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options,
                bool stopsAtAnyHit) {
  Walk<T> walk{.ray = ray, .insideBounds = {}, .steps = {}, .hit = {}, .counts = {}};
  detail::Query<T> query(tree, ray, ray.tMin, ray.tMax);
  query.mask = options.mask;
  const Interval<T> part = query.partInsideTree();
  if (part.isEmpty())
    return walk;
  walk.insideBounds = part;

  Hit<T> hit;
  const auto run = [&]<class Goal>(Goal, const detail::HitChoices<T>* choices) {
    return detail::traverse<Goal>(tree.nodes.front(), query, part, hit,
                                  detail::WalkRecorder<T>(tree.nodes, walk, choices));
  };
  [[maybe_unused]] bool found = false;
  if (detail::hasChoices(options)) {
    const detail::HitChoices<T> choices{options, ray.direction};
    detail::NearestSink<T> nearest(choices, query.interval.tMax, hit);
    detail::AnySink<T> any(choices, query.interval.tMax);
    query.sink = stopsAtAnyHit ? static_cast<detail::HitSink<T>*>(&any) : &nearest;
    found =
        stopsAtAnyHit ? run(detail::AnyOffer{}, &choices) : run(detail::NearestOffer{}, &choices);
  } else {
    found = stopsAtAnyHit ? run(detail::AnyHit{}, nullptr) : run(detail::NearestHit{}, nullptr);
  }
  PLANETREE_ASSERT(found == walk.hit.has_value());
  PLANETREE_ASSERT(stopsAtAnyHit || !found || hit == *walk.hit);
  return walk;
}

}  // namespace

template <class T>
Walk<T> explainIntersection(const TreeView<T>& tree, const Ray<T>& ray,
                            const QueryOptions& options) {
  return explain(tree, ray, options, false);
}

template <class T>
Walk<T> explainOcclusion(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options) {
  return explain(tree, ray, options, true);
}

template Walk<float> explainIntersection(const TreeView<float>&, const Rayf&, const QueryOptions&);
template Walk<double> explainIntersection(const TreeView<double>&, const Rayd&,
                                          const QueryOptions&);
template Walk<float> explainOcclusion(const TreeView<float>&, const Rayf&, const QueryOptions&);
template Walk<double> explainOcclusion(const TreeView<double>&, const Rayd&, const QueryOptions&);

}  // namespace planetree
