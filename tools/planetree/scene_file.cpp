#include "scene_file.hpp"

#include "output_file.hpp"
#include "ray_files/byte_source.hpp"

#include "import/import_scene.hpp"
#include "scene/read_scene.hpp"

namespace planetree::tool {

namespace {

bool isRayScene(const std::filesystem::path& path) {
  return lowerCaseExtension(path) == ".ray";
}

bool isJsonScene(const std::filesystem::path& path) {
  return lowerCaseExtension(path) == ".json";
}

scene::SceneDescription readModelOfScene(const std::filesystem::path& path) {
  return importing::importScene(path);
}

scene::SceneDescription readRay(const std::filesystem::path& path) {
  scene::SceneDescription description = scene::readRayScene(path);
  // The format has a camera for files that have none.
  if (!description.view)
    description.view = scene::View{};
  return description;
}

}  // namespace

bool isSceneFile(const std::filesystem::path& path) {
  return isRayScene(path) || isJsonScene(path);
}

scene::SceneDescription readScene(const std::filesystem::path& path) {
  if (isRayScene(path))
    return readRay(path);
  if (isJsonScene(path))
    return scene::readJsonScene(path, {.model = readModelOfScene});
  return importing::importScene(path == kStandardInput ? "/dev/stdin" : path);
}

}  // namespace planetree::tool
