#include "scene/read_scene.hpp"

#include "support/scene_promises.hpp"

#include <cstdint>
#include <span>

// Scenes of the format .ray. The textures that they may name are those of the repository.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace planetree;
  const std::string name = "scene.ray";
  const auto bytes = std::as_bytes(std::span(data, size));
  auto scene = fuzz::readSceneOrRefuse(
      name, [&] { return scene::readRayScene(bytes, name, PLANETREE_SCENE_DATA); });
  if (scene)
    fuzz::checkScene(std::move(*scene), size);
  return 0;
}
