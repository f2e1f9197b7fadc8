#pragma once

#include "bench/scene/scene_objects.hpp"
#include "render/camera.hpp"

#include <planetree/mesh/triangle_mesh.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace planetree::bench {

/// A mesh, or shapes, with the place it is looked at from. One of the three arrays holds something.
struct BenchScene {
  std::string name;
  TriangleMesh<float> mesh;
  std::vector<Sphere<float>> spheres;
  std::vector<VirtualShape> shapes;
  render::Camera camera;
  double diagonal = 0.0;  ///< of the box around the positions

  [[nodiscard]] SceneObjects objects() const;
};

/// The name of a scene: that of its file without folder and extension.
[[nodiscard]] std::string sceneName(const std::filesystem::path& file);

/// Reads any format that planetree reads. Throws what `importMesh` throws, and `Error` with
/// `InvalidGeometry` if there are no faces, or none that can be hit.
[[nodiscard]] BenchScene loadScene(const std::filesystem::path& file);

/// Sets the camera and the diagonal by the positions of a scene that has its name already.
void frameScene(BenchScene& scene, std::span<const Vec3f> positions);

/// A scene of a mesh that was made in code.
[[nodiscard]] BenchScene makeScene(std::string name, TriangleMesh<float> mesh);

}  // namespace planetree::bench
