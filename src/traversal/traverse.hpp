#pragma once

#include <planetree/detail/geometry_entry.hpp>
#include <planetree/detail/hit_sink.hpp>
#include <planetree/detail/intersection_table.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/node/node.hpp>
#include <planetree/traversal/order_children.hpp>
#include <planetree/traversal/prepared_ray.hpp>
#include <planetree/traversal/query_options.hpp>
#include <planetree/traversal/step_counts.hpp>
#include <planetree/traversal/tree_view.hpp>

#include "support/assert.hpp"

#include <array>
#include <cstdint>
#include <limits>

/// The one loop over the binary tree. What differs between queries are two compile-time choices.
namespace planetree::detail {

/// Looks for the first hit in the order of `isBefore`.
struct NearestHit {
  static constexpr bool kStopsAtAnyHit = false;
  static constexpr bool kOffersHits = false;
};

/// Is content with any hit.
struct AnyHit {
  static constexpr bool kStopsAtAnyHit = true;
  static constexpr bool kOffersHits = false;
};

/// The goals of queries with choices: hits are offered to `Query::sink`, which has the best of them
/// and the end of the search.
struct NearestOffer {
  static constexpr bool kStopsAtAnyHit = false;
  static constexpr bool kOffersHits = true;
};
struct AnyOffer {
  static constexpr bool kStopsAtAnyHit = true;
  static constexpr bool kOffersHits = true;
};
/// The hits do not compete: what is kept hides nothing behind it.
struct EveryOffer {
  static constexpr bool kStopsAtAnyHit = false;
  static constexpr bool kOffersHits = true;
};

template <class T>
struct Request;

/// What an observer is told of a search; this one listens to nothing and costs nothing.
struct Unobserved {
  static constexpr bool kMayThrow = false;

  /// The search is at a split, and goes on in the children as `order` says.
  template <class T>
  void visitSplit(const Node&, const Interval<T>&, const ChildOrder<T>&) noexcept {}
  template <class T>
  void visitLeaf(const Node&, const Interval<T>&) noexcept {}
  /// Of a run of the leaf's objects, so many have been tested.
  template <class T>
  void testObjects(const Request<T>&, const ShearedRay<T>&, const GeometryEntry<T>&, const LeafRun&,
                   std::uint32_t) noexcept {}
  /// A child that waited lies beyond the nearest hit.
  template <class T>
  void leaveOut(const Node&, const Interval<T>&) noexcept {}
  /// A hit is enough; no child that still waits will be visited.
  void stopAtHit() noexcept {}
};

struct Counting : Unobserved {
  StepCounts& steps;

  explicit Counting(StepCounts& counts) noexcept : steps(counts) {}

  template <class T>
  void visitSplit(const Node&, const Interval<T>&, const ChildOrder<T>&) noexcept {
    ++steps.splitNodes;
  }
  template <class T>
  void visitLeaf(const Node&, const Interval<T>&) noexcept {
    ++steps.leafNodes;
  }
  template <class T>
  void testObjects(const Request<T>&, const ShearedRay<T>&, const GeometryEntry<T>&, const LeafRun&,
                   std::uint32_t testedCount) noexcept {
    steps.objects += testedCount;
  }
};

/// What is asked of a tree.
template <class T>
struct Request {
  static constexpr T kLargest = std::numeric_limits<T>::max();

  const TreeView<T>& tree;
  const Ray<T>& asked;
  Interval<T> interval;  ///< hits count if their t lies in here
  std::uint32_t mask = QueryOptions{}.mask;
  HitSink<T>* sink = nullptr;  ///< for goals that offer hits

  Request(const TreeView<T>& ofTree, const Ray<T>& r, T tMin, T tMax) noexcept
      : tree(ofTree),
        asked(r),
        // A hit at infinity could not be told from a miss. A NaN stays.
        interval{tMin, tMax > kLargest ? kLargest : tMax} {}

  [[nodiscard]] bool sees(const GeometryEntry<T>& geometry) const noexcept {
    return (geometry.mask & mask) != 0;
  }
};

/// A ray on its way through the binary form of a tree.
template <class T>
struct Query : Request<T> {
  using Request<T>::tree;
  using Request<T>::interval;

  PreparedRay<T> ray;

  explicit Query(const Request<T>& request) noexcept
      : Request<T>(request), ray(request.asked, request.tree.bounds) {}
  Query(const TreeView<T>& ofTree, const Ray<T>& r, T tMin, T tMax) noexcept
      : Query(Request<T>(ofTree, r, tMin, tMax)) {}

  /// The part of the interval in which the ray may be inside the tree. Clipping comes first:
  /// without it a ray along an axis with infinite tMax would walk through empty cells.
  [[nodiscard]] Interval<T> partInsideTree() const noexcept {
    if (!ray.isValid() || tree.bounds.isEmpty())
      return {T(1), T(0)};
    return ray.clip(tree.bounds, interval);
  }
};

/// Tests objects in rising order of their numbers, one run per geometry. Returns whether `hit` was
/// replaced, or the sink kept one.
template <class Goal, class Observer, class T>
bool visitObjects(std::span<const std::uint32_t> objects, const Request<T>& request,
                  const ShearedRay<T>& ray, Hit<T>& hit,
                  Observer& observer) noexcept(!Observer::kMayThrow) {
  const auto geometries = request.tree.geometries;
  auto rest = objects;
  bool found = false;
  while (!rest.empty()) {
    const std::uint32_t geometry = geometryOf(geometries, rest.front());
    const GeometryEntry<T>& entry = geometries[geometry];
    std::size_t count = rest.size();
    if (geometries.size() > 1) {
      const std::uint64_t end = std::uint64_t{entry.firstObject} + entry.size;
      count = 0;
      while (count < rest.size() && rest[count] < end)
        ++count;
    }
    const LeafRun run{rest.first(count), entry.firstObject, geometry};
    rest = rest.subspan(count);
    if (!request.sees(entry))
      continue;

    const auto [tMin, tMax] = request.interval;
    const IntersectionTable<T>& table = *entry.intersecting;
    const LeafAnswer answer =
        Goal::kOffersHits      ? table.offerHits(entry.range, run, ray, tMin, *request.sink)
        : Goal::kStopsAtAnyHit ? table.findAny(entry.range, run, ray, tMin, tMax)
                               : table.findNearest(entry.range, run, ray, tMin, tMax, hit);
    observer.testObjects(request, ray, entry, run, answer.testedCount);
    found |= answer.found;
    if (Goal::kStopsAtAnyHit && found)
      return true;
  }
  return found;
}

/// Tests the objects of a leaf.
template <class Goal, class Observer, class T>
bool visitLeaf(const LeafNode& leaf, const Query<T>& query, Hit<T>& hit,
               Observer& observer) noexcept(!Observer::kMayThrow) {
  return visitObjects<Goal>(query.tree.references.subspan(leaf.firstReference(), leaf.count()),
                            query, query.ray.sheared, hit, observer);
}

/// Visits, front to back, the leaves below `start` that the ray may meet within `part`, as long as
/// they may hold a hit before `hit`. Returns whether there was one.
template <class Goal, class Observer, class T>
bool traverse(const Node& start, const Query<T>& query, Interval<T> part, Hit<T>& hit,
              Observer observer) noexcept(!Observer::kMayThrow) {
  struct FarChild {
    const Node* node;
    Interval<T> part;
  };
  std::array<FarChild, kMaxTreeDepth> stack;
  std::size_t stackSize = 0;
  const Node* node = &start;
  bool found = false;
  if (part.isEmpty())
    return false;

  while (true) {
    while (!node->isLeaf()) {
      const ChildOrder<T> order = orderChildren(node->split(), query.ray, part);
      observer.visitSplit(*node, part, order);
      if (order.visitsNear && order.visitsFar) {
        PLANETREE_ASSERT(stackSize < stack.size());
        stack[stackSize++] = {order.far, order.farPart};
      }
      node = order.visitsNear ? order.near : order.far;
      part = order.visitsNear ? order.nearPart : order.farPart;
    }

    observer.visitLeaf(*node, part);
    found |= visitLeaf<Goal>(node->leaf(), query, hit, observer);
    if (Goal::kStopsAtAnyHit && found) {
      observer.stopAtHit();
      return true;
    }

    // A hit may lie beyond the leaf it was found in, so the search ends only where the next cell
    // begins beyond it; at the same t a lower id may still win.
    while (true) {
      if (stackSize == 0)
        return found;
      --stackSize;
      if (!(stack[stackSize].part.tMin > (Goal::kOffersHits ? query.sink->tMax : hit.t)))
        break;
      observer.leaveOut(*stack[stackSize].node, stack[stackSize].part);
    }
    node = stack[stackSize].node;
    part = stack[stackSize].part;
  }
}

}  // namespace planetree::detail
