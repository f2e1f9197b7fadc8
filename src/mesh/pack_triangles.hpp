#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include "node/triangle_block.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace planetree::detail {

/// Adds blocks with the faces, in their order, and the box around the faces of each to `bounds`.
/// `objects` are the tree's numbers of the faces; `firstObject` is the number of the mesh's face 0.
void packTriangles(const TriangleMeshView<float>& mesh, std::span<const std::uint32_t> objects,
                   std::uint32_t firstObject, std::vector<TriangleBlock>& blocks,
                   std::vector<Box3>& bounds);

/// The same for a mesh in double. Blocks have room for float: they get the positions relative to
/// `center`, which leaves no more to round off than needs be, each rounded to nearest. Corners that
/// round to the same position share it.
void packRoundedTriangles(const TriangleMeshView<double>& mesh,
                          std::span<const std::uint32_t> objects, std::uint32_t firstObject,
                          const Vec3f& center, std::vector<TriangleBlock>& blocks,
                          std::vector<Box3>& bounds);

}  // namespace planetree::detail
