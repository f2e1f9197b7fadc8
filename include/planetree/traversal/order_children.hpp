#pragma once

#include <planetree/node/node.hpp>
#include <planetree/node/split_node.hpp>
#include <planetree/traversal/prepared_ray.hpp>

namespace planetree {

/// The children of a split in the order in which a ray meets them, each with the part of the ray
/// that may be inside. The two parts overlap by twice the slack, so that no point of the ray is in
/// neither.
template <class T>
struct ChildOrder {
  const Node* near;
  const Node* far;
  bool visitsNear;
  bool visitsFar;
  Interval<T> nearPart;  ///< if visited
  Interval<T> farPart;   ///< if visited
};

/// Decides which children of the split to visit within the interval, which must not be empty: then
/// at least one is visited.
///
/// Near and far are told apart by the sign bit of the direction. The slack bounds the rounding of t
/// and of the intersection tests in clipped cells: without it a ray through a vertex on two planes
/// can miss every cell that holds the vertex. Ize, "Robust BVH ray traversal", JCGT 2013, pads
/// boxes by ulps of t; in contrast to it the slack here also covers the error of the triangle test,
/// which is what lets cells hold only the part of a triangle that is inside. Should t be NaN all
/// the same, every comparison is such that both children are visited over the whole interval.
template <class T>
[[nodiscard]] inline ChildOrder<T> orderChildren(const SplitNode& split, const PreparedRay<T>& ray,
                                                 const Interval<T>& interval) noexcept {
  const AxisRay<T>& along = ray.along(split.axis());
  const T t = along.distanceToPlane(split.position());
  const T latest = t + along.slack;
  const T earliest = t - along.slack;
  const bool fromAbove = along.fromAbove;
  return {
      .near = fromAbove ? &split.right() : &split.left(),
      .far = fromAbove ? &split.left() : &split.right(),
      .visitsNear = !(latest < interval.tMin),
      .visitsFar = !(earliest > interval.tMax),
      .nearPart = {interval.tMin, latest < interval.tMax ? latest : interval.tMax},
      .farPart = {earliest > interval.tMin ? earliest : interval.tMin, interval.tMax},
  };
}

}  // namespace planetree
