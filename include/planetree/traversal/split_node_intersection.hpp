#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/node/split_node.hpp>
#include <planetree/traversal/tree_view.hpp>

/// The broad phase, node by node. These functions answer for the subtree below one split of a tree,
/// under the names of the algorithm as it is taught; whole queries run the same loop from the root.
///
/// All of them look for hits with t in [tMin, tMax] (the ray's own interval is not used) that come
/// before `i`, in the order of `isBefore`. If there is one they put the first of them into `i` and
/// return true; else they leave `i` alone and return false. So a default-made hit is the one to
/// start with. For a split below
/// the root that is a promise about hits inside its cell; objects reach beyond it, and hits out
/// there may be found or not. The split must be a node of `tree`. Masks of
/// geometries and the other options are left to whole queries.
namespace planetree {

/// Searches both children, in whichever way fits the ray.
template <class T>
bool findIntersection(const SplitNode& split, const TreeView<T>& tree, const Ray<T>& r, Hit<T>& i,
                      T tMin, T tMax) noexcept;

/// Searches the child on the side that the ray comes from, over the part of the interval in which
/// the ray may be there. False if that part is empty.
template <class T>
bool findNearestIntersection(const SplitNode& split, const TreeView<T>& tree, const Ray<T>& r,
                             Hit<T>& i, T tMin, T tMax) noexcept;

/// Searches the child on the side that the ray goes to, over the part of the interval in which the
/// ray may be there, unless that part begins beyond `i.t`. A hit in the near child does not end the
/// search by itself: it may lie beyond that child, and a nearer one in this.
template <class T>
bool findFartherIntersection(const SplitNode& split, const TreeView<T>& tree, const Ray<T>& r,
                             Hit<T>& i, T tMin, T tMax) noexcept;

/// For a ray that runs (nearly) along the plane: searches, over the whole interval, the child that
/// the ray runs in, or both if it runs within the slack of the plane. Not for other rays. The loop
/// behind whole queries needs no such case, since preparing a ray keeps its components from zero.
template <class T>
bool calculateAsNearParallel(const SplitNode& split, const TreeView<T>& tree, const Ray<T>& r,
                             Hit<T>& i, T tMin, T tMax) noexcept;

}  // namespace planetree
