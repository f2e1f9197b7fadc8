#pragma once

#include "scene/scene_description.hpp"

#include <filesystem>
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

}  // namespace planetree::scene
