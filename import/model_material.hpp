#pragma once

#include "import/message.hpp"

#include "scene/material.hpp"
#include "scene/texture.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace planetree::importing {

/// A material as a model file has it: what it says, and nothing where it says nothing.
struct ModelMaterial {
  std::string name;
  std::array<std::optional<Vec3d>, kMaterialProperties> values;
  std::array<std::optional<std::uint32_t>, kMaterialProperties> textures;

  [[nodiscard]] const std::optional<Vec3d>& value(MaterialProperty property) const noexcept {
    return values[static_cast<std::size_t>(property)];
  }
  [[nodiscard]] const std::optional<std::uint32_t>& texture(
      MaterialProperty property) const noexcept {
    return textures[static_cast<std::size_t>(property)];
  }
};

/// The surface of Whitted that comes nearest to the material; docs/model_files.md says how and why.
/// What is not finite or negative is taken as if the file said nothing. The textures are those that
/// the material refers to: the parts of metal and roughness are only known as their mean.
[[nodiscard]] scene::Material translateMaterial(const ModelMaterial& material,
                                                std::span<const scene::Texture> textures);

/// What meshes without a material are made of: light clay, without a highlight.
[[nodiscard]] scene::Material clay();

}  // namespace planetree::importing
