#include "import/assimp/scene_sender.hpp"

#include <assimp/scene.h>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace planetree::importing {
namespace {

/// A transform in double: products of many nodes then round far below the float of a coordinate.
class Placement {
 public:
  Placement() = default;

  explicit Placement(const aiMatrix4x4& m) noexcept
      : rows_{{{m.a1, m.a2, m.a3, m.a4}, {m.b1, m.b2, m.b3, m.b4}, {m.c1, m.c2, m.c3, m.c4}}} {}

  /// The placement of a child: its own transform first, then this one.
  [[nodiscard]] Placement of(const Placement& child) const noexcept {
    Placement product;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        double sum = column == 3 ? rows_[row][3] : 0.0;
        for (std::size_t i = 0; i < 3; ++i)
          sum += rows_[row][i] * child.rows_[i][column];
        product.rows_[row][column] = sum;
      }
    }
    return product;
  }

  [[nodiscard]] std::array<double, 3> apply(const aiVector3D& point) const noexcept {
    std::array<double, 3> result;
    for (std::size_t row = 0; row < 3; ++row) {
      result[row] = rows_[row][0] * static_cast<double>(point.x) +
                    rows_[row][1] * static_cast<double>(point.y) +
                    rows_[row][2] * static_cast<double>(point.z) + rows_[row][3];
    }
    return result;
  }

 private:
  std::array<std::array<double, 4>, 3> rows_ = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
};

template <class Item>
std::span<Item> items(Item* first, unsigned count) noexcept {
  return first ? std::span<Item>(first, count) : std::span<Item>();
}

class SceneSender {
 public:
  explicit SceneSender(MessageWriter& writer) noexcept : writer_(writer) {}

  void sendMesh(const aiMesh& mesh, const Placement& placement) {
    writer_.say(MessageKind::Mesh);
    const std::span<const aiVector3D> vertices = items(mesh.mVertices, mesh.mNumVertices);
    vertexCount_ += vertices.size();
    if (vertexCount_ > std::numeric_limits<std::uint32_t>::max())
      throw TooManyVertices();
    for (const aiVector3D& vertex : vertices) {
      const auto [x, y, z] = placement.apply(vertex);
      writer_.addVertex(x, y, z);
    }
    for (const aiFace& face : items(mesh.mFaces, mesh.mNumFaces))
      sendFace(items(face.mIndices, face.mNumIndices));
  }

  void sendUnread() { writer_.sayUnread(unreadCount_); }

 private:
  void sendFace(std::span<const unsigned> corners) {
    // assimp's points and lines.
    if (corners.size() == 1 || corners.size() == 2) {
      ++unreadCount_;
      return;
    }
    writer_.addPolygonWord(static_cast<std::uint32_t>(corners.size()));
    for (const unsigned corner : corners)
      writer_.addPolygonWord(corner);
  }

  MessageWriter& writer_;
  std::uint64_t vertexCount_ = 0;
  std::uint64_t unreadCount_ = 0;
};

}  // namespace

void sendScene(const aiScene& scene, MessageWriter& writer) {
  struct Visit {
    const aiNode* node;
    Placement parent;
  };
  SceneSender sender(writer);
  std::vector<Visit> visits;
  if (scene.mRootNode)
    visits.push_back({scene.mRootNode, Placement()});
  while (!visits.empty()) {
    const Visit visit = visits.back();
    visits.pop_back();
    const Placement placement = visit.parent.of(Placement(visit.node->mTransformation));
    for (const unsigned index : items(visit.node->mMeshes, visit.node->mNumMeshes)) {
      const std::span<aiMesh* const> meshes = items(scene.mMeshes, scene.mNumMeshes);
      if (index < meshes.size() && meshes[index])
        sender.sendMesh(*meshes[index], placement);
      else
        writer.say(MessageKind::Remark, "a node refers to a mesh that does not exist");
    }
    // The last one first: the visits then come in the order of the file.
    const std::span<aiNode* const> children =
        items(visit.node->mChildren, visit.node->mNumChildren);
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
      if (*child)
        visits.push_back({*child, placement});
    }
  }
  sender.sendUnread();
}

}  // namespace planetree::importing
