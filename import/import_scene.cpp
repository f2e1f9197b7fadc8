#include "import/import_scene.hpp"

#include "import/model_material.hpp"
#include "import/own_formats.hpp"
#include "import/read_with_assimp.hpp"

#include "scene/default_lighting.hpp"

#include "support/read_file.hpp"

#include <planetree/error.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace planetree::importing {
namespace {

namespace fs = std::filesystem;
using scene::SceneDescription;

/// A scene of one mesh, of clay.
SceneDescription sceneOf(TriangleMesh<double> mesh) {
  auto shape = std::make_shared<scene::MeshShape>();
  shape->positions = std::move(mesh.positions);
  shape->faces = std::move(mesh.faces);
  SceneDescription scene;
  scene.materials.push_back(clay());
  scene.shapes.push_back({.shape = std::shared_ptr<const scene::MeshShape>(std::move(shape)),
                          .placement = {},
                          .material = 0,
                          .name = {}});
  return scene;
}

SceneDescription readMeshAlone(const fs::path& path, ImportReport& report) {
  SceneDescription scene = sceneOf(importMesh<double>(path, &report));
  scene.remarks = report.remarks;
  return scene;
}

SceneDescription readByAssimp(const fs::path& path, ImportReport& report) {
  std::error_code unknown;
  const std::uintmax_t size = fs::file_size(path, unknown);
  return readSceneWithAssimp(path, usualLimits(unknown ? 0 : size), &report);
}

/// Formats whose files have no materials, or none that are read.
bool isBare(MeshFormat format) noexcept {
  return format == MeshFormat::Ply || format == MeshFormat::Stl || format == MeshFormat::Off;
}

/// Reads a file whose name or lack of a name speaks for our own readers. Materials, if it may have
/// some, are read by assimp; where that fails, the mesh is still good.
SceneDescription readOwnFormats(const fs::path& path, ImportReport& report) {
  SceneDescription bare = readMeshAlone(path, report);
  if (isBare(report.format))
    return bare;
  try {
    ImportReport whole;
    SceneDescription scene = readByAssimp(path, whole);
    if (report.format == MeshFormat::Obj) {
      whole.format = report.format;
      whole.formatName = report.formatName;
    }
    report = std::move(whole);
    return scene;
  } catch (const Error& error) {
    bare.remarks.push_back(std::string("materials, normals and textures are not read: ") +
                           error.what());
    return bare;
  }
}

SceneDescription readAny(const fs::path& path, ImportReport& report) {
  detail::requireReadable(path);
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored) || fs::file_size(path, ignored) == 0)
    return readMeshAlone(path, report);
  if (isNamedForOwnReaders(path))
    return readOwnFormats(path, report);
  try {
    return readByAssimp(path, report);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::UnknownFormat)
      throw;
  }
  return readOwnFormats(path, report);
}

/// Says what the file has and the scene has not.
void addLosses(const ImportReport& report, std::vector<std::string>& remarks) {
  if (report.skippedPolygonCount > 0) {
    std::string remark = std::to_string(report.skippedPolygonCount) + " of " +
                         std::to_string(report.polygonCount) + " faces are left out";
    if (!report.skipped.empty()) {
      const SkippedPolygon& first = report.skipped.front();
      remark += ", the first since face " + std::to_string(first.polygon) + " " + first.reason;
    }
    remarks.push_back(std::move(remark));
  }
  const std::uint64_t unread = report.unreadPrimitiveCount;
  if (unread == 1)
    remarks.emplace_back("a point, line or curve is left out: it cannot be hit");
  if (unread > 1) {
    remarks.push_back(std::to_string(unread) +
                      " points, lines or curves are left out: they cannot be hit");
  }
}

}  // namespace

SceneDescription importScene(const fs::path& path, ImportReport* report) {
  ImportReport found;
  SceneDescription scene = readAny(path, found);
  scene.name = path.filename().string();
  addLosses(found, scene.remarks);
  if (scene::addDefaultLighting(scene))
    scene.remarks.push_back("the file has no lights: a key and a fill light were added");
  if (report)
    *report = std::move(found);
  return scene;
}

}  // namespace planetree::importing
