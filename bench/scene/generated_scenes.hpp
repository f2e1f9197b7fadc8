#pragma once

#include <planetree/mesh/triangle_mesh.hpp>

#include <cstdint>

/// Scenes that every machine can make for itself, with +y up. They are the same everywhere but for
/// the rounding of the mathematical functions, and never change: figures of different years are
/// compared on them.
namespace planetree::bench {

/// Mountains: two million triangles of even size in one surface, seen smaller than a pixel. With
/// another number of squares along each side, two triangles each, the same mountains: finer squares
/// have finer details too.
[[nodiscard]] TriangleMesh<float> makeTerrain(std::uint32_t squares = 1024);

/// A grove: some six hundred thousand long thin triangles of twigs, and small ones of leaves, that
/// fill space and hide little.
[[nodiscard]] TriangleMesh<float> makeFoliage();

/// A furnished hall with columns: walls of two triangles beside ornaments of thousands.
[[nodiscard]] TriangleMesh<float> makeInterior();

}  // namespace planetree::bench
