#include "import/assimp/texture_coordinates.hpp"

#include <cmath>

namespace planetree::importing {
namespace {

using Numbers = std::array<double, 2>;

/// KHR_texture_transform: in coordinates whose v is down, scale, then rotate by `r` against the
/// clock around the origin, then move. assimp 5.2 keeps the angle negated, and moves so that a
/// rotation around the middle of the image would be right; but then its own step that applies it
/// takes what it moves by modulo one. So its way is gone back here, and the right one taken.
void setGltfTransform(const aiUVTransform& kept, TextureCoordinates& map) {
  const auto scaleX = static_cast<double>(kept.mScaling.x);
  const auto scaleY = static_cast<double>(kept.mScaling.y);
  const double c = std::cos(-static_cast<double>(kept.mRotation));
  const double s = std::sin(-static_cast<double>(kept.mRotation));
  const double offsetX = static_cast<double>(kept.mTranslation.x) - 0.5 * scaleX * (s - c + 1.0);
  const double offsetY =
      1.0 - scaleY + 0.5 * scaleY * (s + c - 1.0) - static_cast<double>(kept.mTranslation.y);
  // u' = c sx u + s sy v + ox, v' = -s sx u + c sy v + oy, and v, v' are 1 less what assimp has.
  map.u = {c * scaleX, s * scaleX};
  map.v = {-s * scaleY, c * scaleY};
  map.origin = {s * scaleY + offsetX, 1.0 - c * scaleY - offsetY};
}

/// As assimp documents it: a rotation around the middle.
void setTransform(const aiUVTransform& kept, TextureCoordinates& map) {
  const auto scaleX = static_cast<double>(kept.mScaling.x);
  const auto scaleY = static_cast<double>(kept.mScaling.y);
  const double c = std::cos(static_cast<double>(kept.mRotation));
  const double s = std::sin(static_cast<double>(kept.mRotation));
  map.u = {scaleX * c, scaleY * s};
  map.v = {-scaleX * s, scaleY * c};
  map.origin = {scaleX * (0.5 - 0.5 * c + 0.5 * s) + static_cast<double>(kept.mTranslation.x),
                scaleY * (0.5 - 0.5 * s - 0.5 * c) + static_cast<double>(kept.mTranslation.y)};
}

}  // namespace

std::optional<aiTextureType> colourTexture(const aiMaterial& material) {
  for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE,
                                   aiTextureType_EMISSIVE, aiTextureType_AMBIENT}) {
    if (material.GetTextureCount(type) > 0)
      return type;
  }
  return std::nullopt;
}

TextureCoordinates textureCoordinates(const aiMaterial* material, bool isGltf) {
  TextureCoordinates map;
  const auto type = material ? colourTexture(*material) : std::nullopt;
  if (!type)
    return map;
  int channel = 0;
  if (material->Get(AI_MATKEY_UVWSRC(*type, 0), channel) == AI_SUCCESS && channel >= 0)
    map.channel = static_cast<unsigned>(channel);
  aiUVTransform kept;
  if (material->Get(AI_MATKEY_UVTRANSFORM(*type, 0), kept) != AI_SUCCESS)
    return map;
  if (isGltf)
    setGltfTransform(kept, map);
  else
    setTransform(kept, map);
  return map;
}

}  // namespace planetree::importing
