#pragma once

#include "traversal/hit_choices.hpp"
#include "traversal/search_wide.hpp"
#include "traversal/traverse.hpp"

#include <optional>

namespace planetree::detail {

/// Offers the hits of the request to its sink, through the form of the tree that is fastest. `Goal`
/// is `NearestOffer`, `AnyOffer` or `EveryOffer`, as fits the sink. Returns whether one was kept.
template <class Goal, class T>
bool offerHits(const Request<T>& request, StepCounts* steps) noexcept {
  Hit<T> unused;
  // Steps are those of the binary form.
  if (!steps) {
    if (const std::optional<bool> found = searchWide<Goal>(request, unused))
      return *found;
  }
  const Query<T> query(request);
  const Node& root = query.tree.nodes.front();
  const Interval<T> part = query.partInsideTree();
  return steps ? traverse<Goal>(root, query, part, unused, Counting(*steps))
               : traverse<Goal>(root, query, part, unused, Unobserved{});
}

/// The nearest hit that counts, into `hit`. Its interval is that of the request.
template <class T>
bool findNearestChoice(Request<T>& request, const HitChoices<T>& choices, StepCounts* steps,
                       Hit<T>& hit) noexcept {
  NearestSink<T> sink(choices, request.interval.tMax, hit);
  request.sink = &sink;
  return offerHits<NearestOffer>(request, steps);
}

/// Whether any hit counts.
template <class T>
bool findAnyChoice(Request<T>& request, const HitChoices<T>& choices, StepCounts* steps) noexcept {
  AnySink<T> sink(choices, request.interval.tMax);
  request.sink = &sink;
  return offerHits<AnyOffer>(request, steps);
}

}  // namespace planetree::detail
