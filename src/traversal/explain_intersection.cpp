#include <planetree/traversal/explain_intersection.hpp>

#include "traversal/traverse.hpp"
#include "traversal/walk_recorder.hpp"

#include "support/assert.hpp"

namespace planetree {
namespace {

template <class Goal, class T>
Walk<T> explain(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options) {
  Walk<T> walk{.ray = ray, .insideBounds = {}, .steps = {}, .hit = {}, .counts = {}};
  detail::Query<T> query(tree, ray, ray.tMin, ray.tMax);
  query.mask = options.mask;
  const Interval<T> part = query.partInsideTree();
  if (part.isEmpty())
    return walk;
  walk.insideBounds = part;
  Hit<T> hit;
  [[maybe_unused]] const bool found = detail::traverse<Goal>(
      tree.nodes.front(), query, part, hit, detail::WalkRecorder<T>(tree.nodes, walk));
  PLANETREE_ASSERT(found == walk.hit.has_value());
  PLANETREE_ASSERT(Goal::kStopsAtAnyHit || !found || hit == *walk.hit);
  return walk;
}

}  // namespace

template <class T>
Walk<T> explainIntersection(const TreeView<T>& tree, const Ray<T>& ray,
                            const QueryOptions& options) {
  return explain<detail::NearestHit>(tree, ray, options);
}

template <class T>
Walk<T> explainOcclusion(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options) {
  return explain<detail::AnyHit>(tree, ray, options);
}

template Walk<float> explainIntersection(const TreeView<float>&, const Rayf&, const QueryOptions&);
template Walk<double> explainIntersection(const TreeView<double>&, const Rayd&,
                                          const QueryOptions&);
template Walk<float> explainOcclusion(const TreeView<float>&, const Rayf&, const QueryOptions&);
template Walk<double> explainOcclusion(const TreeView<double>&, const Rayd&, const QueryOptions&);

}  // namespace planetree
