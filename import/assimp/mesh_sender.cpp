#include "import/assimp/mesh_sender.hpp"

#include <limits>

namespace planetree::importing {

void MeshSender::begin(std::span<const aiVector3D> vertices) {
  writer_.say(MessageKind::Mesh);
  vertexCount_ += vertices.size();
  if (vertexCount_ > std::numeric_limits<std::uint32_t>::max())
    throw TooManyVertices();
}

void MeshSender::sendFace(std::span<const unsigned> corners) {
  // assimp's points and lines.
  if (corners.size() == 1 || corners.size() == 2) {
    ++unreadCount_;
    return;
  }
  writer_.addPolygonWord(static_cast<std::uint32_t>(corners.size()));
  for (const unsigned corner : corners)
    writer_.addPolygonWord(corner);
}

}  // namespace planetree::importing
