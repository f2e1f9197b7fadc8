#pragma once

#include <assimp/material.h>
#include <assimp/vector3.h>

#include <array>
#include <optional>

namespace planetree::importing {

/// The texture that gives a surface its colour: the one that its coordinates are for.
[[nodiscard]] std::optional<aiTextureType> colourTexture(const aiMaterial& material);

/// Which coordinates of a vertex are those of the texture, and how they are moved. v is up.
struct TextureCoordinates {
  unsigned channel = 0;
  // What (1, 0), (0, 1) and (0, 0) become.
  std::array<double, 2> u{1, 0};
  std::array<double, 2> v{0, 1};
  std::array<double, 2> origin{0, 0};

  [[nodiscard]] std::array<double, 2> at(const aiVector3D& uv) const noexcept {
    const auto x = static_cast<double>(uv.x);
    const auto y = static_cast<double>(uv.y);
    return {u[0] * x + v[0] * y + origin[0], u[1] * x + v[1] * y + origin[1]};
  }
};

/// Those of a material, which may be null.
[[nodiscard]] TextureCoordinates textureCoordinates(const aiMaterial* material, bool isGltf);

}  // namespace planetree::importing
