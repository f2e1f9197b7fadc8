#pragma once

#include "import/import_mesh.hpp"
#include "import/message_reader.hpp"

#include "mesh/mesh_builder.hpp"
#include "mesh/mesh_input.hpp"
#include "mesh/vertex_welder.hpp"

#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

namespace planetree::importing {

/// Puts a mesh together from messages, none of which it trusts. Equal vertices become one: many
/// readers of assimp make new ones for each polygon.
template <std::floating_point T>
class MeshReceiver {
 public:
  explicit MeshReceiver(const std::string& fileName);
  MeshReceiver(const MeshReceiver&) = delete;
  MeshReceiver& operator=(const MeshReceiver&) = delete;

  /// Takes messages to the last one. Throws `Error` for a failure that they tell of,
  /// and what `MessageReader::next` throws.
  void receiveAll(MessageReader& messages);

  [[nodiscard]] TriangleMesh<T> takeMesh() noexcept { return builder_.takeMesh(); }
  [[nodiscard]] ImportReport takeReport();

 private:
  void receive(Message& message);
  void receiveRemark(const Message& message);
  void beginMesh();
  void receiveVertices(Message& message);
  void receivePolygons(Message& message);
  void endPolygon();
  [[nodiscard]] Error failure(Message& message) const;

  detail::MeshInput input_;
  detail::MeshBuilder<T> builder_;
  detail::VertexWelder<T> welder_;
  ImportReport report_;
  /// For each vertex of the present mesh the index of the one that it has become.
  std::vector<std::uint32_t> vertices_;
  std::vector<std::uint32_t> corners_;        ///< of the present polygon
  std::uint64_t missingCornerCount_ = 0;      ///< how many are still to come
  std::vector<std::int64_t> builderCorners_;  ///< kept to allocate but once
};

extern template class MeshReceiver<float>;
extern template class MeshReceiver<double>;

/// A text from outside, fit to be shown in a line: without control characters, and not too long.
[[nodiscard]] std::string presentable(const std::string& text);

}  // namespace planetree::importing
