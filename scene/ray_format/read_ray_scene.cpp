#include "scene/ray_format/scene_reader.hpp"
#include "scene/read_scene.hpp"
#include "support/read_file.hpp"

namespace planetree::scene {

SceneDescription readRayScene(const std::filesystem::path& path) {
  const planetree::detail::FileContent content = planetree::detail::readFile(path);
  return readRayScene(content.bytes(), path.string(), path.parent_path());
}

SceneDescription readRayScene(std::span<const std::byte> bytes, const std::string& name,
                              const std::filesystem::path& folder) {
  SceneDescription scene;
  scene.name = std::filesystem::path(name).filename().string();
  ray_format::SceneReader(ray_format::Lexer(bytes, name), folder, scene).read();
  return scene;
}

}  // namespace planetree::scene
