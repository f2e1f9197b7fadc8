#pragma once

#include <planetree/traversal/step_counts.hpp>

#include "traversal/hit_choices.hpp"
#include "traversal/traverse.hpp"

/// Queries with choices. Behind calls on purpose: what they need on the stack is none of the
/// business of queries without.
namespace planetree::detail {

/// Offers the hits of the request to its sink, through the form of the tree that is fastest. `Goal`
/// is `NearestOffer`, `AnyOffer` or `EveryOffer`, as fits the sink. Returns whether one was kept.
template <class Goal, class T>
bool offerHits(const Request<T>& request, StepCounts* steps) noexcept;

/// The nearest hit that counts, into `hit`. Its interval is that of the request.
template <class T>
bool findNearestChoice(Request<T>& request, const HitChoices<T>& choices, StepCounts* steps,
                       Hit<T>& hit) noexcept;

/// Answers a query of which `hasChoices` is true as `find_intersection.hpp` says.
template <class T>
bool findNearestChoice(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options,
                       StepCounts* steps, Hit<T>& hit) noexcept;
template <class T>
bool findAnyChoice(const TreeView<T>& tree, const Ray<T>& ray, const QueryOptions& options,
                   StepCounts* steps) noexcept;

}  // namespace planetree::detail
