#pragma once

#include <planetree/mesh/triangle_mesh.hpp>

#include <cstddef>
#include <string>

namespace planetree::bench {

/// A mesh of so many faces, at least 2, as a program would write it: mountains.
[[nodiscard]] TriangleMesh<float> makeRayMesh(std::size_t faceCount);

/// The text of a `.ray` scene of the mesh alone, with normals to be generated.
[[nodiscard]] std::string rayText(const TriangleMesh<float>& mesh);

}  // namespace planetree::bench
