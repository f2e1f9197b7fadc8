#pragma once

#include <planetree/batch/batch_options.hpp>
#include <planetree/batch/ray_arrays.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/traversal/tree_view.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

/// Many rays in one call. The answers are those of asking ray by ray, bit for bit, in the order of
/// the rays, whatever the order, the hint and the number of threads are.
///
/// Among triangles in float, without choices that leave something out, rays are taken along
/// together: sixteen that go the same way as one packet, as rays of a camera do, row by row of the
/// picture; others take turns, so that they do not wait for memory. That is up to three times as
/// fast as ray by ray. Shapes, doubles and choices gain the threads alone.
///
/// Spans must have one size, or `Error` with `InvalidOption` is thrown. Rays and hits must not
/// overlap. A batch takes no memory that grows with the number of rays; each thread needs some 500
/// kilobytes of stack. Any number of batches at once, from any threads, also from oneTBB tasks of
/// the caller.
namespace planetree {

/// The nearest hit of each ray; a miss is a default-made hit. Returns how many rays hit something.
template <class T>
std::size_t findIntersections(const TreeView<T>& tree, std::span<const Ray<T>> rays,
                              std::span<Hit<T>> hits, const BatchOptions& options = {},
                              const BatchControl& control = {});
/// The same with an array for each number.
template <class T>
std::size_t findIntersections(const TreeView<T>& tree, const RayArrays<T>& rays,
                              const HitArrays<T>& hits, const BatchOptions& options = {},
                              const BatchControl& control = {});

/// For each ray 1 if it hits anything, else 0. Returns how many do.
template <class T>
std::size_t areOccluded(const TreeView<T>& tree, std::span<const Ray<T>> rays,
                        std::span<std::uint8_t> flags, const BatchOptions& options = {},
                        const BatchControl& control = {});
template <class T>
std::size_t areOccluded(const TreeView<T>& tree, const RayArrays<T>& rays,
                        std::span<std::uint8_t> flags, const BatchOptions& options = {},
                        const BatchControl& control = {});

#define PLANETREE_DECLARE(T)                                                                 \
  extern template std::size_t findIntersections(const TreeView<T>&, std::span<const Ray<T>>, \
                                                std::span<Hit<T>>, const BatchOptions&,      \
                                                const BatchControl&);                        \
  extern template std::size_t findIntersections(const TreeView<T>&, const RayArrays<T>&,     \
                                                const HitArrays<T>&, const BatchOptions&,    \
                                                const BatchControl&);                        \
  extern template std::size_t areOccluded(const TreeView<T>&, std::span<const Ray<T>>,       \
                                          std::span<std::uint8_t>, const BatchOptions&,      \
                                          const BatchControl&);                              \
  extern template std::size_t areOccluded(const TreeView<T>&, const RayArrays<T>&,           \
                                          std::span<std::uint8_t>, const BatchOptions&,      \
                                          const BatchControl&);
PLANETREE_DECLARE(float)
PLANETREE_DECLARE(double)
#undef PLANETREE_DECLARE

}  // namespace planetree
