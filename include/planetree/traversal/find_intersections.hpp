#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/traversal/query_options.hpp>
#include <planetree/traversal/step_counts.hpp>
#include <planetree/traversal/tree_view.hpp>

#include <cstddef>
#include <optional>
#include <span>

/// All hits of a ray, each exactly once, in the order of `isBefore`: by (t, geometry, primitive,
/// part), the key of a hit. An object may be hit several times, a sphere where the ray enters and
/// where it leaves, but at most once at each t. The hits are bit for bit those of asking every
/// object one by one, whatever the build options were. They are the hits in [ray.tMin, ray.tMax]
/// that the options accept; the nearest of them is what `findIntersection` with the same options
/// answers. Any number of threads at once; nothing is allocated. Each function adds to `steps`
/// unless it is null.
namespace planetree {

/// How many hits a span was filled with.
struct FoundHits {
  std::size_t count = 0;
  /// Whether there are hits behind them, for which the span had no room.
  bool hasMore = false;

  friend constexpr bool operator==(const FoundHits&, const FoundHits&) noexcept = default;
};

/// Fills `hits` with the first hits of the ray; what stands behind `count` is left alone.
///
/// One walk through the tree. If there are more hits than room, the walk ends where the last one
/// kept is; their number is not found out, as hits without room cannot be told from such as were
/// met before. `findNextIntersections` goes on behind them. Each hit is sorted in from the back,
/// which takes few steps as cells come front to back, and at worst as many as there are hits.
template <class T>
[[nodiscard]] FoundHits findIntersections(const TreeView<T>& tree, const Ray<T>& ray,
                                          std::span<Hit<T>> hits, const QueryOptions& options = {},
                                          StepCounts* steps = nullptr) noexcept;

/// The same with the hits behind `after`. It may be one of `hits`, such as the last of the portion
/// before, and need not be a hit of this ray: only its key is read. A miss is behind all hits.
template <class T>
[[nodiscard]] FoundHits findNextIntersections(const TreeView<T>& tree, const Ray<T>& ray,
                                              const Hit<T>& after, std::span<Hit<T>> hits,
                                              const QueryOptions& options = {},
                                              StepCounts* steps = nullptr) noexcept;

/// The first hit behind `after`, or nothing. As costly as `findIntersection`: it begins anew each
/// time, but skips what ends before `after.t`. To walk over all hits of a ray,
///
///     for (auto hit = findIntersection(tree, ray); hit;
///          hit = findNextIntersection(tree, ray, *hit))
template <class T>
[[nodiscard]] std::optional<Hit<T>> findNextIntersection(const TreeView<T>& tree, const Ray<T>& ray,
                                                         const Hit<T>& after,
                                                         const QueryOptions& options = {},
                                                         StepCounts* steps = nullptr) noexcept;

#define PLANETREE_DECLARE(T)                                                                     \
  extern template FoundHits findIntersections(const TreeView<T>&, const Ray<T>&,                 \
                                              std::span<Hit<T>>, const QueryOptions&,            \
                                              StepCounts*) noexcept;                             \
  extern template FoundHits findNextIntersections(const TreeView<T>&, const Ray<T>&,             \
                                                  const Hit<T>&, std::span<Hit<T>>,              \
                                                  const QueryOptions&, StepCounts*) noexcept;    \
  extern template std::optional<Hit<T>> findNextIntersection(const TreeView<T>&, const Ray<T>&,  \
                                                             const Hit<T>&, const QueryOptions&, \
                                                             StepCounts*) noexcept;
PLANETREE_DECLARE(float)
PLANETREE_DECLARE(double)
#undef PLANETREE_DECLARE

}  // namespace planetree
