#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/traversal/query_options.hpp>
#include <planetree/traversal/tree_view.hpp>
#include <planetree/traversal/walk.hpp>

namespace planetree {

/// Searches as `findIntersection` does, by the same loop, and tells every step of it. For looking
/// at single rays: it allocates, and tests each object of a leaf once more on its own, so that a
/// filter is shown hits more often. Any number
/// of threads at once. Throws nothing but std::bad_alloc.
template <class T>
[[nodiscard]] Walk<T> explainIntersection(const TreeView<T>& tree, const Ray<T>& ray,
                                          const QueryOptions& options = {});

/// The same for `isOccluded`. The hit is that of the object which the search was content with.
template <class T>
[[nodiscard]] Walk<T> explainOcclusion(const TreeView<T>& tree, const Ray<T>& ray,
                                       const QueryOptions& options = {});

extern template Walk<float> explainIntersection(const TreeView<float>&, const Rayf&,
                                                const QueryOptions&);
extern template Walk<double> explainIntersection(const TreeView<double>&, const Rayd&,
                                                 const QueryOptions&);
extern template Walk<float> explainOcclusion(const TreeView<float>&, const Rayf&,
                                             const QueryOptions&);
extern template Walk<double> explainOcclusion(const TreeView<double>&, const Rayd&,
                                              const QueryOptions&);

}  // namespace planetree
