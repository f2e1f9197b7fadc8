#pragma once

#include "import/answer_text.hpp"
#include "import/import_mesh.hpp"
#include "import/message_reader.hpp"
#include "import/model_lights.hpp"
#include "import/model_material.hpp"
#include "import/polygon_words.hpp"

#include "scene/scene_description.hpp"

#include "mesh/mesh_builder.hpp"
#include "mesh/mesh_input.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace planetree::importing {

/// Puts a scene together from messages, none of which it trusts: what refers to something that was
/// not told of, and lists that do not fit each other, break the rules. Numbers that cannot be are
/// the file's fault, and left out with a remark.
class SceneReceiver {
 public:
  explicit SceneReceiver(const std::string& fileName);
  SceneReceiver(const SceneReceiver&) = delete;
  SceneReceiver& operator=(const SceneReceiver&) = delete;

  /// Takes messages to the last one. Throws `Error` for a failure that they tell of,
  /// and what `MessageReader::next` throws.
  void receiveAll(MessageReader& messages);

  /// The scene, without a name and without lights that the file does not have.
  [[nodiscard]] scene::SceneDescription takeScene();
  [[nodiscard]] ImportReport takeReport();

 private:
  struct TextureParts {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<Vec3f> texels;
  };
  struct Mesh {
    std::shared_ptr<const scene::MeshShape> shape;
    std::optional<std::uint32_t> material;
  };
  struct PlacedMesh {
    std::uint32_t mesh = 0;
    scene::Affine placement;
    std::string name;
  };

  void receive(Message& message);
  void beginTexture(Message& message);
  void receiveTexels(Message& message);
  void endTexture();
  void receiveMaterialValue(Message& message);
  void receiveMaterialTexture(Message& message);
  void beginMesh();
  void receiveMeshMaterial(Message& message);
  void receiveVertices(Message& message);
  void receivePolygons(Message& message);
  void receiveNormals(Message& message);
  void receiveCoordinates(Message& message);
  void endMesh();
  void addToReport(const MeshReadReport& part);
  void receivePlacement(Message& message);
  void receiveLight(Message& message);
  void receiveCamera(Message& message);
  [[nodiscard]] ModelMaterial& presentMaterial();
  [[nodiscard]] scene::MeshShape& presentMesh();
  [[nodiscard]] std::uint32_t clayIndex(scene::SceneDescription& scene);

  detail::MeshInput input_;
  ImportReport report_;
  RemarkList remarks_;     ///< of the other side
  RemarkList ownRemarks_;  ///< about numbers that cannot be

  std::optional<TextureParts> texture_;  ///< the present one
  std::uint64_t promisedTexels_ = 0;     ///< of all textures
  std::vector<scene::Texture> textures_;
  std::vector<ModelMaterial> materials_;

  std::optional<scene::MeshShape> mesh_;  ///< the present one
  std::optional<detail::MeshBuilder<double>> builder_;
  std::optional<std::uint32_t> meshMaterial_;
  PolygonWords polygon_;
  std::vector<Mesh> meshes_;

  std::vector<PlacedMesh> placements_;
  std::vector<ModelLight> lights_;
  std::optional<scene::View> view_;
  std::optional<std::uint32_t> clay_;
};

}  // namespace planetree::importing
