#include "import/assimp/material_sender.hpp"

#include "import/assimp/texture_coordinates.hpp"

#include <assimp/GltfMaterial.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planetree::importing {
namespace {

struct Key {
  MaterialProperty property;
  const char* key;
};

constexpr std::array kColours = {
    Key{MaterialProperty::Ambient, "$clr.ambient"},
    Key{MaterialProperty::Diffuse, "$clr.diffuse"},
    Key{MaterialProperty::Specular, "$clr.specular"},
    Key{MaterialProperty::Emissive, "$clr.emissive"},
    Key{MaterialProperty::Reflective, "$clr.reflective"},
    Key{MaterialProperty::Transparent, "$clr.transparent"},
    // Where there is one, it says the same as the diffuse colour and says it better.
    Key{MaterialProperty::Diffuse, "$clr.base"},
};

constexpr std::array kNumbers = {
    Key{MaterialProperty::Opacity, "$mat.opacity"},
    Key{MaterialProperty::Shininess, "$mat.shininess"},
    Key{MaterialProperty::ShininessStrength, "$mat.shinpercent"},
    Key{MaterialProperty::Reflectivity, "$mat.reflectivity"},
    Key{MaterialProperty::RefractiveIndex, "$mat.refracti"},
    Key{MaterialProperty::Illumination, "$mat.illum"},
    Key{MaterialProperty::Metallic, "$mat.metallicFactor"},
    Key{MaterialProperty::Roughness, "$mat.roughnessFactor"},
    Key{MaterialProperty::Transmission, "$mat.transmission.factor"},
    Key{MaterialProperty::Glossiness, "$mat.glossinessFactor"},
    Key{MaterialProperty::Thickness, "$mat.volume.thicknessFactor"},
};

constexpr std::array kMaps = {
    std::pair{MaterialProperty::Ambient, aiTextureType_AMBIENT},
    std::pair{MaterialProperty::Specular, aiTextureType_SPECULAR},
    std::pair{MaterialProperty::Emissive, aiTextureType_EMISSIVE},
    std::pair{MaterialProperty::Metallic, aiTextureType_METALNESS},
    std::pair{MaterialProperty::Roughness, aiTextureType_DIFFUSE_ROUGHNESS},
};

constexpr std::array kUnreadMaps = {
    std::pair{aiTextureType_HEIGHT, "bump maps"},
    std::pair{aiTextureType_NORMALS, "normal maps"},
    std::pair{aiTextureType_SHININESS, "maps of shininess"},
    std::pair{aiTextureType_OPACITY, "maps of opacity"},
    std::pair{aiTextureType_DISPLACEMENT, "maps of displacement"},
    std::pair{aiTextureType_LIGHTMAP, "light and occlusion maps"},
    std::pair{aiTextureType_REFLECTION, "maps of reflection"},
    std::pair{aiTextureType_TRANSMISSION, "maps of transmission"},
};

bool hasAlpha(const aiMaterial& material) {
  aiString mode;
  return material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != AI_SUCCESS ||
         std::string_view(mode.C_Str()) == "BLEND";
}

std::string nameOf(const aiMaterial* material) {
  aiString name;
  if (material && material->Get(AI_MATKEY_NAME, name) == AI_SUCCESS)
    return name.C_Str();
  return {};
}

}  // namespace

void MaterialSender::send(const aiMaterial* material) {
  // Textures come first: a material's properties stand together.
  std::vector<std::pair<MaterialProperty, std::uint32_t>> textures;
  const auto sendTexture = [&](MaterialProperty property, aiTextureType type) {
    aiString reference;
    if (material->GetTexture(type, 0, &reference) != AI_SUCCESS)
      return;
    if (const auto index = textures_.send(reference.C_Str()))
      textures.emplace_back(property, *index);
  };
  if (material) {
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
      if (textures.empty())
        sendTexture(MaterialProperty::Diffuse, type);
    }
    for (const auto& [property, type] : kMaps)
      sendTexture(property, type);
  }
  writer_.say(MessageKind::Material, nameOf(material));
  if (!material)
    return;
  sendValues(*material);
  for (const auto& [property, index] : textures)
    writer_.say(MessageKind::MaterialTexture, Payload().add(property).add(index));
  sendUnreadMaps(*material);
}

void MaterialSender::sendValues(const aiMaterial& material) {
  const auto sendValue = [&](MaterialProperty property, const aiColor3D& value) {
    writer_.say(MessageKind::MaterialValue, Payload()
                                                .add(property)
                                                .add(static_cast<double>(value.r))
                                                .add(static_cast<double>(value.g))
                                                .add(static_cast<double>(value.b)));
  };
  for (const auto& [property, key] : kColours) {
    aiColor3D colour;
    if (material.Get(key, 0, 0, colour) == AI_SUCCESS)
      sendValue(property, colour);
  }
  for (const auto& [property, key] : kNumbers) {
    // assimp tells the alpha of glTF files as opacity, whether it is in use or not.
    if (property == MaterialProperty::Opacity && isGltf_ && !hasAlpha(material))
      continue;
    ai_real number = 0;
    if (material.Get(key, 0, 0, number) == AI_SUCCESS)
      sendValue(property, {number, 0, 0});
  }
  const aiMaterialProperty* ignored = nullptr;
  if (aiGetMaterialProperty(&material, "$mat.gltf.unlit", 0, 0, &ignored) == AI_SUCCESS)
    sendFlag(MaterialProperty::Unlit);
  if (isGltf_)
    sendFlag(MaterialProperty::LinearColour);
}

void MaterialSender::sendFlag(MaterialProperty property) {
  writer_.say(MessageKind::MaterialValue, Payload().add(property).add(std::array{1.0, 0.0, 0.0}));
}

void MaterialSender::sendUnreadMaps(const aiMaterial& material) {
  for (const auto& [type, words] : kUnreadMaps) {
    if (material.GetTextureCount(type) > 0)
      writer_.say(MessageKind::Remark, std::string(words) + " are not read");
  }
  aiString mode;
  if (colourTexture(material) && material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == AI_SUCCESS &&
      std::string_view(mode.C_Str()) != "OPAQUE")
    writer_.say(MessageKind::Remark, "the alpha of textures is not read");
}

}  // namespace planetree::importing
