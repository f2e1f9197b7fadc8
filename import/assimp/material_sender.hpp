#pragma once

#include "import/assimp/message_writer.hpp"
#include "import/assimp/texture_sender.hpp"

#include <assimp/material.h>

namespace planetree::importing {

/// Sends what the file says of materials, and before it their textures.
class MaterialSender {
 public:
  MaterialSender(bool isGltf, TextureSender& textures, MessageWriter& writer) noexcept
      : isGltf_(isGltf), textures_(textures), writer_(writer) {}

  /// Sends the material, without properties if it is null.
  void send(const aiMaterial* material);

 private:
  void sendValues(const aiMaterial& material);
  void sendFlag(MaterialProperty property);
  void sendUnreadMaps(const aiMaterial& material);

  bool isGltf_;
  TextureSender& textures_;
  MessageWriter& writer_;
};

}  // namespace planetree::importing
