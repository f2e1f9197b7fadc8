#pragma once

#include "scene/scene_description.hpp"

#include <filesystem>

/// Which reader takes a file with materials and lights.
namespace planetree::tool {

/// Whether the file is a scene, by its name or its first words: one that is rendered with its
/// lights. All others are models.
[[nodiscard]] bool isSceneFile(const std::filesystem::path& path);

/// Whether the file has materials and lights or may well have some: a scene, or a model in one of
/// the formats that come with them. Those that are read by planetree itself are taken for bare;
/// only OBJ may name some, in a file of its own.
[[nodiscard]] bool hasSurfaces(const std::filesystem::path& path);

/// Reads a scene, or a model with its materials and with lights if it has none. Throws `Error` if
/// it cannot be read.
[[nodiscard]] scene::SceneDescription readScene(const std::filesystem::path& path);

}  // namespace planetree::tool
