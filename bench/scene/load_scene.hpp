#pragma once

#include "render/camera.hpp"

#include <planetree/mesh/triangle_mesh.hpp>

#include <filesystem>
#include <string>

namespace planetree::bench {

/// A mesh with the place it is looked at from.
struct BenchScene {
  std::string name;
  TriangleMesh<float> mesh;
  render::Camera camera;
  double diagonal = 0.0;  ///< of the box around the positions
};

/// The name of a scene: that of its file without folder and extension.
[[nodiscard]] std::string sceneName(const std::filesystem::path& file);

/// Reads any format that planetree reads. Throws what `importMesh` throws, and `Error` with
/// `InvalidGeometry` if there are no faces, or none that can be hit.
[[nodiscard]] BenchScene loadScene(const std::filesystem::path& file);

/// A scene of a mesh that was made in code.
[[nodiscard]] BenchScene makeScene(std::string name, TriangleMesh<float> mesh);

}  // namespace planetree::bench
