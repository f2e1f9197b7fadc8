#pragma once

#include "import/assimp/message_writer.hpp"
#include "import/assimp/node_placement.hpp"

#include <assimp/camera.h>
#include <assimp/light.h>

#include <span>

namespace planetree::importing {

/// Sends lights and cameras in world coordinates. Each is where the node of its name is.
class LightSender {
 public:
  LightSender(bool isGltf, std::span<const PlacedNode> nodes, MessageWriter& writer) noexcept
      : isGltf_(isGltf), nodes_(nodes), writer_(writer) {}

  void send(const aiLight& light) const;
  void send(const aiCamera& camera) const;

 private:
  /// Null, and a remark, if there is no such node.
  [[nodiscard]] const Placement* placementOf(const aiString& name) const;

  bool isGltf_;
  std::span<const PlacedNode> nodes_;
  MessageWriter& writer_;
};

}  // namespace planetree::importing
