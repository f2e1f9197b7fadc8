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

}  // namespace planetree::detail
