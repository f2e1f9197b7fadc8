#pragma once

#include "scene/scene_description.hpp"

#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace planetree::scene {

/// Reads a scene in the `.ray` format (docs/ray_format.md). Textures and cube maps it names are
/// read too, relative to the folder of the file. Throws `Error` with line and column:
/// `FileNotReadable`, `MalformedFile`, and for a texture what `readTexture` throws, with the place
/// where the scene names it.
[[nodiscard]] SceneDescription readRayScene(const std::filesystem::path& path);
/// The same for bytes; `name` is for errors, `folder` what textures are relative to.
[[nodiscard]] SceneDescription readRayScene(std::span<const std::byte> bytes,
                                            const std::string& name,
                                            const std::filesystem::path& folder);

/// How a scene file reads the other files that it names.
struct SceneFileReaders {
  /// A model with its materials and textures, for the shapes of type "model".
  std::function<SceneDescription(const std::filesystem::path&)> model = {};
  std::function<Texture(const std::filesystem::path&)> texture =
      [](const std::filesystem::path& path) { return readTexture(path); };
};

/// Reads a scene from a JSON file (docs/scene_files.md). The files that it names are relative to
/// its folder. Throws `Error` with line and column of the culprit: `FileNotReadable`,
/// `MalformedFile`, `CapacityExceeded`, and for a model or a texture what its reader throws, with
/// the place where the scene names it. A scene that names models where there is no reader for them
/// is malformed.
[[nodiscard]] SceneDescription readJsonScene(const std::filesystem::path& path,
                                             const SceneFileReaders& readers);
/// The same for bytes; `name` is for errors, `folder` what files are relative to.
[[nodiscard]] SceneDescription readJsonScene(std::span<const std::byte> bytes,
                                             const std::string& name,
                                             const std::filesystem::path& folder,
                                             const SceneFileReaders& readers);

}  // namespace planetree::scene
