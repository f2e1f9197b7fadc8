#pragma once

#include "scene/ray_format/material_reader.hpp"
#include "scene/ray_format/token_reader.hpp"
#include "scene/scene_description.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace planetree::scene::ray_format {

/// Reads one trimesh.
class MeshReader {
 public:
  /// `material` is that of the mesh so far, which those of its points inherit from. All must
  /// outlive this.
  MeshReader(TokenReader& tokens, MaterialReader& materials, const std::uint32_t& material)
      : tokens_(tokens), materials_(materials), material_(material) {}

  /// What stands behind `mesh`, the keyword. `readCommon(keyword)` reads what all shapes may have,
  /// or is false.
  [[nodiscard]] std::shared_ptr<const MeshShape> read(
      const Token& mesh, const std::function<bool(const Token&)>& readCommon);

 private:
  void readEntry(const Token& keyword);
  void readFaces(TokenReader& tokens);
  void readFace(TokenReader& tokens);
  [[nodiscard]] std::uint32_t readCorner(TokenReader& tokens) const;
  void requireCorners(const Token& mesh);
  void requireCount(std::size_t count, const std::optional<TextPlace>& place,
                    const std::string& what) const;
  void generateNormals();

  TokenReader& tokens_;
  MaterialReader& materials_;
  const std::uint32_t& material_;
  MeshShape mesh_;
  std::uint32_t largestCorner_ = 0;
  /// Known once the points are read.
  std::optional<std::size_t> pointCount_;
  /// Before the list of faces, to find the place of a wrong corner there.
  std::optional<TokenReader> beforeFaces_;
  std::optional<TextPlace> normals_;
  std::optional<TextPlace> materialList_;
  std::optional<TextPlace> coordinates_;
  std::optional<TextPlace> generatesNormals_;
};

}  // namespace planetree::scene::ray_format
