#pragma once

#include <planetree/geometry/ray.hpp>

#include "soak/closed_solids.hpp"
#include "soak/fast_random.hpp"

#include <cstdint>
#include <span>

/// Streams of rays at closed meshes, block by block. A block is the same whenever and by whichever
/// thread it is made. The targets go round: one after the other all vertices, edges and faces have
/// their turn.
namespace planetree::test {

/// Rays from inside: none may leave. The blocks take turns in what their rays have in common:
///  - nothing: each has an origin of its own and another kind of target;
///  - the origin: the targets are corners, edges or middles of faces that are neighbours;
///  - the origin and nearly the direction: a picture, the rays steps of a few ulps or more apart,
///    with a vertex or a point of an edge in the middle;
///  - they run along axes, level with vertices;
///  - they start close to the surface and graze it: along an edge, in the plane of a face, or at a
///    small angle to it.
template <class T>
void fillWithInnerRays(const PlacedSolid<T>& solid, std::uint64_t seed, std::uint64_t block,
                       std::span<Ray<T>> rays);

/// Rays from outside at the same targets, and past them.
template <class T>
void fillWithOuterRays(const PlacedSolid<T>& solid, std::uint64_t seed, std::uint64_t block,
                       std::span<Ray<T>> rays);

/// A point that is surely inside, anywhere in a ball around the core of the face; often one with so
/// few bits that the direction to a vertex is not rounded.
template <class T>
[[nodiscard]] Vec3<T> innerPoint(const PlacedSolid<T>& solid, std::size_t face,
                                 FastRandom& random) noexcept;

/// One as near to a point of the face as is surely inside.
template <class T>
[[nodiscard]] Vec3<T> innerPointAtSurface(const PlacedSolid<T>& solid, std::size_t face,
                                          FastRandom& random) noexcept;

}  // namespace planetree::test
