#include <planetree/traversal/split_node_intersection.hpp>

#include "traversal/traverse.hpp"

#include <utility>

namespace planetree {
namespace {

/// Runs the loop below one child of the split, chosen from the order in which the ray meets them.
template <class T, class Choose>
bool searchChildren(const SplitNode& split, const TreeView<T>& tree, const Ray<T>& r, Hit<T>& i,
                    T tMin, T tMax, Choose&& choose) noexcept {
  const detail::Query<T> query(tree, r, tMin, tMax);
  const Interval<T> part = query.partInsideTree();
  if (part.isEmpty())
    return false;
  return choose(orderChildren(split, query.ray, part), [&](const Node& child,
                                                           const Interval<T>& childPart) {
    return detail::traverse<detail::NearestHit>(child, query, childPart, i, detail::Unobserved{});
  });
}

}  // namespace

template <class T>
bool findIntersection(const SplitNode& split, const TreeView<T>& tree, const Ray<T>& r, Hit<T>& i,
                      T tMin, T tMax) noexcept {
  if (PreparedRay<T>(r, tree.bounds).isNearlyParallel(split.axis())) {
    return calculateAsNearParallel(split, tree, r, i, tMin, tMax);
  }
  const bool foundNear = findNearestIntersection(split, tree, r, i, tMin, tMax);
  const bool foundFar = findFartherIntersection(split, tree, r, i, tMin, tMax);
  return foundNear || foundFar;
}

template <class T>
bool findNearestIntersection(const SplitNode& split, const TreeView<T>& tree, const Ray<T>& r,
                             Hit<T>& i, T tMin, T tMax) noexcept {
  return searchChildren(split, tree, r, i, tMin, tMax,
                        [](const ChildOrder<T>& order, const auto& search) {
                          return order.visitsNear && search(*order.near, order.nearPart);
                        });
}

template <class T>
bool findFartherIntersection(const SplitNode& split, const TreeView<T>& tree, const Ray<T>& r,
                             Hit<T>& i, T tMin, T tMax) noexcept {
  return searchChildren(
      split, tree, r, i, tMin, tMax, [&i](const ChildOrder<T>& order, const auto& search) {
        const bool isBeyondHit = order.farPart.tMin > i.t;
        return order.visitsFar && !isBeyondHit && search(*order.far, order.farPart);
      });
}

template <class T>
bool calculateAsNearParallel(const SplitNode& split, const TreeView<T>& tree, const Ray<T>& r,
                             Hit<T>& i, T tMin, T tMax) noexcept {
  const detail::Query<T> query(tree, r, tMin, tMax);
  const Interval<T> part = query.partInsideTree();
  if (part.isEmpty())
    return false;
  const T height = r.origin[split.axis()] - static_cast<T>(split.position());
  bool found = false;
  for (const auto& [child, distance] :
       {std::pair(&split.left(), height), std::pair(&split.right(), -height)}) {
    const bool isInside = distance <= query.ray.distanceSlack;
    if (isInside) {
      found |= detail::traverse<detail::NearestHit>(*child, query, part, i, detail::Unobserved{});
    }
  }
  return found;
}

#define PLANETREE_INSTANTIATE(T)                                                                  \
  template bool findIntersection(const SplitNode&, const TreeView<T>&, const Ray<T>&, Hit<T>&, T, \
                                 T) noexcept;                                                     \
  template bool findNearestIntersection(const SplitNode&, const TreeView<T>&, const Ray<T>&,      \
                                        Hit<T>&, T, T) noexcept;                                  \
  template bool findFartherIntersection(const SplitNode&, const TreeView<T>&, const Ray<T>&,      \
                                        Hit<T>&, T, T) noexcept;                                  \
  template bool calculateAsNearParallel(const SplitNode&, const TreeView<T>&, const Ray<T>&,      \
                                        Hit<T>&, T, T) noexcept;
PLANETREE_INSTANTIATE(float)
PLANETREE_INSTANTIATE(double)
#undef PLANETREE_INSTANTIATE

}  // namespace planetree
