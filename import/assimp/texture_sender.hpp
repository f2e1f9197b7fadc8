#pragma once

#include "import/assimp/message_writer.hpp"

#include "scene/texture.hpp"

#include <assimp/scene.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace planetree::importing {

/// Decodes and sends the textures that a scene refers to, each once. Images are hostile bytes like
/// the rest of a model, and so they are decoded here, in the process that may crash; what is sent
/// are texels. A texture that cannot be had becomes a remark.
class TextureSender {
 public:
  TextureSender(const aiScene& scene, std::filesystem::path folder, MessageWriter& writer)
      : scene_(scene), folder_(std::move(folder)), writer_(writer) {}

  /// The index of the texture that the file calls by this name; it is sent if it is new. Nothing if
  /// it cannot be had.
  [[nodiscard]] std::optional<std::uint32_t> send(const std::string& reference);

 private:
  void leaveOut(const std::string& reference, const std::string& reason);
  [[nodiscard]] scene::Texture read(const std::string& reference) const;
  [[nodiscard]] scene::Texture readEmbedded(const aiTexture& texture,
                                            const std::string& reference) const;
  void sendTexels(const scene::Texture& texture, const std::string& reference);

  const aiScene& scene_;
  std::filesystem::path folder_;
  MessageWriter& writer_;
  std::map<std::string, std::optional<std::uint32_t>> sent_;
  std::uint32_t count_ = 0;
  std::uint64_t texelCount_ = 0;
};

}  // namespace planetree::importing
