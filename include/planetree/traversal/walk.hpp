#pragma once

#include <planetree/geometry/axis.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/traversal/prepared_ray.hpp>
#include <planetree/traversal/step_counts.hpp>

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

/// What a query did, step by step; see explain_intersection.hpp.
namespace planetree {

/// A node that a ray came to, or was to come to.
template <class T>
struct NodeVisit {
  std::uint32_t node = 0;   ///< index among the nodes of the tree
  std::uint32_t level = 1;  ///< counts from 1 at the root, as `BuildOptions::depthLimit` does
  Interval<T> part = {};    ///< the part of the ray that may be inside the cell
};

/// The ray came to a split. It goes on in the near child, if that is visited; the far one waits.
template <class T>
struct SplitStep {
  NodeVisit<T> visit;
  Axis axis = Axis::X;
  float position = 0.0f;
  bool leftIsNear = true;               ///< else the right child is the near one
  std::optional<Interval<T>> nearPart;  ///< nothing if the near child is not visited
  std::optional<Interval<T>> farPart;   ///< nothing if the far child is not visited
};

/// One object that a leaf tested.
template <class T>
struct ObjectTest {
  std::uint32_t geometry = kNoId;
  std::uint32_t primitive = kNoId;
  /// Where the ray first hits the object within its own [tMin, tMax], of the hits that the options
  /// of the query accept. That may be outside of the leaf's cell, or behind a hit that is known
  /// already.
  std::optional<Hit<T>> hit;
  bool isAccepted = false;  ///< whether it became the hit of the query, until a nearer one came
};

/// The ray came to a leaf.
template <class T>
struct LeafStep {
  NodeVisit<T> visit;
  std::uint32_t objectCount = 0;  ///< objects in the leaf
  /// The objects tested, in their order. Fewer than there are if `QueryOptions::mask` hides some,
  /// or if one of them was hit and any hit would do.
  std::vector<ObjectTest<T>> tests;
};

/// A child that waited and is not visited after all: its part of the ray begins beyond the nearest
/// hit, or any hit was enough.
template <class T>
struct LeftOutStep {
  NodeVisit<T> visit;
};

template <class T>
using WalkStep = std::variant<SplitStep<T>, LeafStep<T>, LeftOutStep<T>>;

/// The walk of one ray through a tree.
template <class T>
struct Walk {
  Ray<T> ray;
  /// The part of the ray that may be inside the bounds of the tree; nothing if there is none, or
  /// if the ray is one that misses everything (see `Ray`).
  std::optional<Interval<T>> insideBounds;
  std::vector<WalkStep<T>> steps;  ///< in the order in which they were made
  std::optional<Hit<T>> hit;       ///< the answer of the query
  StepCounts counts;               ///< as the query itself counts them
};

}  // namespace planetree
