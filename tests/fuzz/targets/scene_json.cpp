#include "scene/read_scene.hpp"

#include "support/scene_promises.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

// Scenes in JSON. Other files are not looked for: each name stands for the same small model, or the
// same texture; names that begin with '!' for files that cannot be read.

namespace planetree::fuzz {
namespace {

void refuseMissing(const std::filesystem::path& path) {
  if (path.filename().string().starts_with('!')) {
    throw Error(ErrorCode::FileNotReadable, "there is no such file", "Name another one.",
                Error::Place{.file = path.string()});
  }
}

scene::Texture textureAt(const std::filesystem::path& path) {
  refuseMissing(path);
  return {2, 1, std::vector<Vec3f>{{1.0f, 0.5f, 0.0f}, {0.0f, 0.5f, 1.0f}}};
}

scene::SceneDescription modelAt(const std::filesystem::path& path) {
  refuseMissing(path);
  scene::MeshShape mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}};
  mesh.coordinates = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  scene::SceneDescription model;
  model.textures.push_back(textureAt(path));
  model.materials.emplace_back().diffuse.texture = 0;
  model.shapes.push_back({.shape = std::make_shared<const scene::MeshShape>(std::move(mesh)),
                          .placement = {},
                          .material = 0});
  return model;
}

}  // namespace
}  // namespace planetree::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace planetree;
  const std::string name = "scene.json";
  const auto bytes = std::as_bytes(std::span(data, size));
  const scene::SceneFileReaders readers{.model = fuzz::modelAt, .texture = fuzz::textureAt};
  auto scene = fuzz::readSceneOrRefuse(
      name, [&] { return scene::readJsonScene(bytes, name, "nowhere", readers); });
  if (scene)
    fuzz::checkScene(std::move(*scene), size);
  return 0;
}
