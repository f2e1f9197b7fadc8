#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/traversal/query_options.hpp>
#include <planetree/traversal/step_counts.hpp>
#include <planetree/traversal/tree_view.hpp>

#include <optional>

namespace planetree {

/// The nearest hit in [ray.tMin, ray.tMax], or nothing. Of hits at the same t the one with the
/// lower (geometry, primitive, part) wins, so the answer depends on the ray and the objects alone:
/// it is bit for bit what testing every object one by one would give. Adds to `steps` unless it is
/// null. Any number of threads at once; no allocation.
template <class T>
[[nodiscard]] std::optional<Hit<T>> findIntersection(const TreeView<T>& tree, const Ray<T>& ray,
                                                     const QueryOptions& options = {},
                                                     StepCounts* steps = nullptr) noexcept;

/// Whether any object is hit in [ray.tMin, ray.tMax]. Cheaper than the nearest hit: it stops at the
/// first one found, whichever that is.
template <class T>
[[nodiscard]] bool isOccluded(const TreeView<T>& tree, const Ray<T>& ray,
                              const QueryOptions& options = {},
                              StepCounts* steps = nullptr) noexcept;

extern template std::optional<Hitf> findIntersection(const TreeView<float>&, const Rayf&,
                                                     const QueryOptions&, StepCounts*) noexcept;
extern template std::optional<Hitd> findIntersection(const TreeView<double>&, const Rayd&,
                                                     const QueryOptions&, StepCounts*) noexcept;
extern template bool isOccluded(const TreeView<float>&, const Rayf&, const QueryOptions&,
                                StepCounts*) noexcept;
extern template bool isOccluded(const TreeView<double>&, const Rayd&, const QueryOptions&,
                                StepCounts*) noexcept;

}  // namespace planetree
