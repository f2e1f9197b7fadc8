#pragma once

#include "scene/ray_format/token_reader.hpp"
#include "scene/scene_description.hpp"

#include <cstdint>
#include <filesystem>
#include <map>

namespace planetree::scene::ray_format {

/// Reads the images that a scene names, each of them once.
class TextureReader {
 public:
  /// `scene` must outlive it. Names are relative to `folder`.
  TextureReader(SceneDescription& scene, std::filesystem::path folder)
      : scene_(scene), folder_(std::move(folder)) {}

  /// The index of the image in the scene. Throws what `readTexture` does, with the place of `file`.
  [[nodiscard]] std::uint32_t read(const TokenReader& tokens, const Token& file);

 private:
  SceneDescription& scene_;
  std::filesystem::path folder_;
  std::map<std::filesystem::path, std::uint32_t> indices_;
};

}  // namespace planetree::scene::ray_format
