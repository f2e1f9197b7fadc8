#pragma once

#include <planetree/mesh/triangle_mesh.hpp>

#include "node/triangle_block.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace planetree::detail {

/// Adds blocks with the faces, in their order, and returns how many. `objects` are the tree's
/// numbers of the faces; `firstObject` is the number of the mesh's face 0.
std::size_t packTriangles(const TriangleMeshView<float>& mesh,
                          std::span<const std::uint32_t> objects, std::uint32_t firstObject,
                          std::vector<TriangleBlock>& blocks);

/// The same for a mesh in double. Blocks have room for float: they get the positions relative to
/// `center`, which leaves no more to round off than needs be, each rounded to nearest. Corners that
/// round to the same position share it.
std::size_t packRoundedTriangles(const TriangleMeshView<double>& mesh,
                                 std::span<const std::uint32_t> objects, std::uint32_t firstObject,
                                 const Vec3f& center, std::vector<TriangleBlock>& blocks);

}  // namespace planetree::detail
