#include "bench/scene/load_scene.hpp"

#include "bench/scene/cameras.hpp"
#include "import/import_mesh.hpp"

#include <planetree/error.hpp>
#include <planetree/geometry/box3.hpp>

#include <utility>

namespace planetree::bench {

namespace {

double diagonalOf(const TriangleMesh<float>& mesh) {
  Box3 bounds;
  for (const Vec3f& position : mesh.positions) {
    if (isFinite(position))
      bounds.extend(position);
  }
  return bounds.isEmpty() ? 0.0 : length(Vec3d(bounds.upper) - Vec3d(bounds.lower));
}

}  // namespace

std::string sceneName(const std::filesystem::path& file) {
  return file.stem().string();
}

BenchScene loadScene(const std::filesystem::path& file) {
  TriangleMesh<float> mesh = importing::importMesh<float>(file);
  if (mesh.faces.empty()) {
    throw Error(ErrorCode::InvalidGeometry, "the model has no faces", "Name another model.",
                {.file = file.string()});
  }
  return makeScene(sceneName(file), std::move(mesh));
}

BenchScene makeScene(std::string name, TriangleMesh<float> mesh) {
  // Embree reads sixteen bytes from each position on.
  mesh.positions.reserve(mesh.positions.size() + 1);
  BenchScene scene;
  scene.camera = sceneCamera(name, mesh.positions);
  scene.diagonal = diagonalOf(mesh);
  scene.name = std::move(name);
  scene.mesh = std::move(mesh);
  return scene;
}

}  // namespace planetree::bench
