#pragma once

#include "import/assimp/message_writer.hpp"

#include <assimp/mesh.h>

#include <array>
#include <cstdint>
#include <span>

namespace planetree::importing {

/// Thrown where a scene has more vertices than 32 bits can count.
struct TooManyVertices {};

/// Sends meshes, and counts what is common to all of them. What assimp hands over is checked as far
/// as it says how large it is: it may be wrong after a bad file.
class MeshSender {
 public:
  explicit MeshSender(MessageWriter& writer) noexcept : writer_(writer) {}

  /// Begins a mesh; `position` maps an `aiVector3D` to three doubles.
  template <class Position>
  void send(const aiMesh& mesh, const Position& position);
  /// Says how many points and lines there were.
  void sendUnread() { writer_.sayUnread(unreadCount_); }

 private:
  void begin(std::span<const aiVector3D> vertices);
  void sendFace(std::span<const unsigned> corners);

  MessageWriter& writer_;
  std::uint64_t vertexCount_ = 0;
  std::uint64_t unreadCount_ = 0;
};

}  // namespace planetree::importing

#include "import/assimp/items.hpp"

template <class Position>
void planetree::importing::MeshSender::send(const aiMesh& mesh, const Position& position) {
  const std::span<const aiVector3D> vertices = items(mesh.mVertices, mesh.mNumVertices);
  begin(vertices);
  for (const aiVector3D& vertex : vertices)
    writer_.add(MessageKind::Vertices, position(vertex));
  for (const aiFace& face : items(mesh.mFaces, mesh.mNumFaces))
    sendFace(items(face.mIndices, face.mNumIndices));
}
