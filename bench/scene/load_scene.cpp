#include "bench/scene/load_scene.hpp"

#include "bench/scene/cameras.hpp"
#include "import/import_mesh.hpp"

#include <planetree/error.hpp>
#include <planetree/geometry/box3.hpp>

#include <fmt/format.h>

#include <cstddef>
#include <utility>

namespace planetree::bench {

namespace {

double diagonalOf(std::span<const Vec3f> positions) {
  Box3 bounds;
  for (const Vec3f& position : positions) {
    if (isFinite(position))
      bounds.extend(position);
  }
  return bounds.isEmpty() ? 0.0 : length(Vec3d(bounds.upper) - Vec3d(bounds.lower));
}

/// Whether `buildTree` would leave in a face. Nearly always the first one answers it.
bool canBeHit(const TriangleMesh<float>& mesh) {
  const TriangleMeshView<float> view = mesh.view();
  for (std::size_t face = 0; face < view.size(); ++face) {
    if (!view[face].isUsable())
      continue;
    const auto [a, b, c] = view.corners(face);
    if (a != b && b != c && c != a)
      return true;
  }
  return false;
}

}  // namespace

SceneObjects BenchScene::objects() const {
  if (!spheres.empty())
    return std::span(spheres);
  if (!shapes.empty())
    return std::span(shapes);
  return mesh;
}

void frameScene(BenchScene& scene, std::span<const Vec3f> positions) {
  scene.camera = sceneCamera(scene.name, positions);
  scene.diagonal = diagonalOf(positions);
}

std::string sceneName(const std::filesystem::path& file) {
  return file.stem().string();
}

BenchScene loadScene(const std::filesystem::path& file) {
  TriangleMesh<float> mesh = importing::importMesh<float>(file);
  if (mesh.faces.empty()) {
    throw Error(ErrorCode::InvalidGeometry, "has no triangles",
                "Rays do not hit point clouds and curves: name another model.",
                {.file = file.string()});
  }
  if (!canBeHit(mesh)) {
    throw Error(
        ErrorCode::InvalidGeometry,
        fmt::format("has {} {}, none of which can be hit", mesh.faces.size(),
                    mesh.faces.size() == 1 ? "triangle" : "triangles"),
        "Check how the model was exported: planetree info tells what is wrong with the first one.",
        {.file = file.string()});
  }
  return makeScene(sceneName(file), std::move(mesh));
}

BenchScene makeScene(std::string name, TriangleMesh<float> mesh) {
  // Embree reads sixteen bytes from each position on.
  mesh.positions.reserve(mesh.positions.size() + 1);
  BenchScene scene;
  scene.name = std::move(name);
  frameScene(scene, mesh.positions);
  scene.mesh = std::move(mesh);
  return scene;
}

}  // namespace planetree::bench
