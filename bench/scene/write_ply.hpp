#pragma once

#include <planetree/mesh/triangle_mesh.hpp>

#include <string>

namespace planetree::bench {

/// The bytes of a binary PLY file: float positions, triangles with 32-bit indices.
[[nodiscard]] std::string plyBytes(const TriangleMesh<float>& mesh);

}  // namespace planetree::bench
