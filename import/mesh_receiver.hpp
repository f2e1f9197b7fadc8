#pragma once

#include "import/answer_text.hpp"
#include "import/import_mesh.hpp"
#include "import/message_reader.hpp"
#include "import/polygon_words.hpp"

#include "mesh/mesh_builder.hpp"
#include "mesh/mesh_input.hpp"
#include "mesh/vertex_welder.hpp"

#include <concepts>
#include <cstdint>
#include <span>
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
  void beginMesh();
  void receiveVertices(Message& message);
  void receivePolygons(Message& message);
  void addPolygon(std::span<const std::uint32_t> corners);

  detail::MeshInput input_;
  detail::MeshBuilder<T> builder_;
  detail::VertexWelder<T> welder_;
  ImportReport report_;
  RemarkList remarks_;
  /// For each vertex of the present mesh the index of the one that it has become.
  std::vector<std::uint32_t> vertices_;
  PolygonWords polygon_;
  std::vector<std::int64_t> builderCorners_;  ///< kept to allocate but once
};

extern template class MeshReceiver<float>;
extern template class MeshReceiver<double>;

}  // namespace planetree::importing
