#pragma once

#include "import/assimp/message_writer.hpp"

#include <filesystem>
#include <string_view>

struct aiScene;

namespace planetree::importing {

/// Sends each mesh of the scene as often as its nodes place it, in world coordinates.
void sendGeometry(const aiScene& scene, MessageWriter& writer);

/// Sends the scene with its textures, materials, lights and cameras: each mesh once, in its own
/// coordinates, and then its placements. Textures are looked for in `folder`. `format` is what
/// assimp calls the format of the file.
void sendScene(const aiScene& scene, std::string_view format, const std::filesystem::path& folder,
               MessageWriter& writer);

}  // namespace planetree::importing
