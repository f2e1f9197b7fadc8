#pragma once

#include <planetree/mesh/triangle_mesh.hpp>

#include <string>
#include <vector>

namespace planetree::test {

struct ModelFile {
  std::string name;
  std::string bytes;
};

/// The mesh in each of the formats that `readMesh` reads.
[[nodiscard]] std::vector<ModelFile> modelFilesOf(const TriangleMesh<float>& mesh);

/// Models that are read, but not all of them, and models that are refused.
[[nodiscard]] std::vector<ModelFile> faultyModelFiles();

}  // namespace planetree::test
