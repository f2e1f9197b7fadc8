#include "import/assimp/scene_sender.hpp"

#include "import/assimp/items.hpp"
#include "import/assimp/light_sender.hpp"
#include "import/assimp/material_sender.hpp"
#include "import/assimp/mesh_sender.hpp"
#include "import/assimp/node_placement.hpp"
#include "import/assimp/texture_coordinates.hpp"
#include "import/assimp/texture_sender.hpp"

#include <assimp/scene.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace planetree::importing {
namespace {

std::array<double, 3> inDouble(const aiVector3D& v) noexcept {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// Calls `use(index, mesh, placed node)` for each mesh of each node.
template <class Use>
void forEachPlacedMesh(const aiScene& scene, std::span<const PlacedNode> nodes,
                       MessageWriter& writer, const Use& use) {
  const std::span<aiMesh* const> meshes = items(scene.mMeshes, scene.mNumMeshes);
  for (const PlacedNode& placed : nodes) {
    for (const unsigned index : items(placed.node->mMeshes, placed.node->mNumMeshes)) {
      if (index < meshes.size() && meshes[index])
        use(index, *meshes[index], placed);
      else
        writer.say(MessageKind::Remark, "a node refers to a mesh that does not exist");
    }
  }
}

class SceneSender {
 public:
  SceneSender(const aiScene& scene, std::string_view format, MessageWriter& writer)
      : scene_(scene),
        writer_(writer),
        isGltf_(format == "glTF2"),
        meshSender_(writer),
        nodes_(placedNodes(scene)) {}

  void sendMaterials(const std::filesystem::path& folder) {
    TextureSender textures(scene_, folder, writer_);
    MaterialSender sender(isGltf_, textures, writer_);
    for (const aiMaterial* const material : materials())
      sender.send(material);
  }

  void sendMeshes() {
    std::vector<std::optional<std::uint32_t>> sent(scene_.mNumMeshes);
    std::uint32_t count = 0;
    forEachPlacedMesh(scene_, nodes_, writer_,
                      [&](unsigned index, const aiMesh& mesh, const PlacedNode&) {
                        if (sent[index])
                          return;
                        sent[index] = count++;
                        sendMesh(mesh);
                      });
    forEachPlacedMesh(
        scene_, nodes_, writer_, [&](unsigned index, const aiMesh& mesh, const PlacedNode& placed) {
          const aiString& name = placed.node->mName.length > 0 ? placed.node->mName : mesh.mName;
          writer_.say(MessageKind::Placement, Payload()
                                                  .add(sent[index].value_or(0))
                                                  .add(placed.placement.columns())
                                                  .addText(name.C_Str()));
        });
    meshSender_.sendUnread();
  }

  void sendLightsAndCameras() {
    const LightSender sender(isGltf_, nodes_, writer_);
    for (const aiLight* const light : items(scene_.mLights, scene_.mNumLights)) {
      if (light)
        sender.send(*light);
    }
    for (const aiCamera* const camera : items(scene_.mCameras, scene_.mNumCameras)) {
      if (camera)
        sender.send(*camera);
    }
  }

 private:
  [[nodiscard]] std::span<aiMaterial* const> materials() const noexcept {
    return items(scene_.mMaterials, scene_.mNumMaterials);
  }

  void sendMesh(const aiMesh& mesh) {
    meshSender_.send(mesh, inDouble);
    for (const aiVector3D& normal : items(mesh.mNormals, mesh.mNumVertices))
      writer_.add(MessageKind::Normals, inDouble(normal));
    const aiMaterial* material = nullptr;
    if (mesh.mMaterialIndex < materials().size()) {
      material = materials()[mesh.mMaterialIndex];
      writer_.say(MessageKind::MeshMaterial, Payload().add(mesh.mMaterialIndex));
    }
    sendCoordinates(mesh, material);
    if (mesh.mColors[0])
      writer_.say(MessageKind::Remark, "the colours of vertices are not read");
  }

  void sendCoordinates(const aiMesh& mesh, const aiMaterial* material) {
    const TextureCoordinates map = textureCoordinates(material, isGltf_);
    if (map.channel >= AI_MAX_NUMBER_OF_TEXTURECOORDS)
      return;
    for (const aiVector3D& uv : items(mesh.mTextureCoords[map.channel], mesh.mNumVertices))
      writer_.add(MessageKind::Coordinates, map.at(uv));
  }

  const aiScene& scene_;
  MessageWriter& writer_;
  bool isGltf_;
  MeshSender meshSender_;
  std::vector<PlacedNode> nodes_;
};

}  // namespace

void sendGeometry(const aiScene& scene, MessageWriter& writer) {
  MeshSender sender(writer);
  forEachPlacedMesh(scene, placedNodes(scene), writer,
                    [&](unsigned, const aiMesh& mesh, const PlacedNode& placed) {
                      sender.send(mesh,
                                  [&](const aiVector3D& p) { return placed.placement.point(p); });
                    });
  sender.sendUnread();
}

void sendScene(const aiScene& scene, std::string_view format, const std::filesystem::path& folder,
               MessageWriter& writer) {
  SceneSender sender(scene, format, writer);
  sender.sendMaterials(folder);
  sender.sendMeshes();
  sender.sendLightsAndCameras();
}

}  // namespace planetree::importing
