#include "scene_file.hpp"

#include "output_file.hpp"
#include "ray_files/byte_source.hpp"

#include "import/import_scene.hpp"
#include "import/own_formats.hpp"
#include "scene/read_scene.hpp"
#include "support/read_file.hpp"

#include <array>
#include <fstream>
#include <string_view>
#include <system_error>

namespace planetree::tool {

namespace {

/// By its name, or by its first words: such files are old, and go by many names.
bool isRayScene(const std::filesystem::path& path) {
  if (lowerCaseExtension(path) == ".ray")
    return true;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    return false;
  constexpr std::string_view kBegin = "SBT-raytracer";
  std::array<char, kBegin.size()> begin{};
  std::ifstream(path, std::ios::binary).read(begin.data(), begin.size());
  return std::string_view(begin.data(), begin.size()) == kBegin;
}

bool isJsonScene(const std::filesystem::path& path) {
  return lowerCaseExtension(path) == ".json";
}

scene::SceneDescription readModelOfScene(const std::filesystem::path& path) {
  planetree::detail::refuseDeviceOrPipe(path, "Name a file with a model.");
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

bool hasSurfaces(const std::filesystem::path& path) {
  return isSceneFile(path) || !importing::isNamedForOwnReaders(path);
}

scene::SceneDescription readScene(const std::filesystem::path& path) {
  if (isRayScene(path))
    return readRay(path);
  if (isJsonScene(path))
    return scene::readJsonScene(path, {.model = readModelOfScene});
  return importing::importScene(path == kStandardInput ? "/dev/stdin" : path);
}

}  // namespace planetree::tool
