#pragma once

#include "scene/json_format/json_text.hpp"
#include "scene/json_format/json_value.hpp"
#include "scene/json_format/texture_table.hpp"
#include "scene/scene_description.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace planetree::scene::json_format {

/// The materials of a scene: those with names, those of single shapes, and one for shapes that have
/// none.
class MaterialTable {
 public:
  MaterialTable(const JsonText& text, TextureTable& textures, SceneDescription& scene) noexcept
      : text_(text), textures_(textures), scene_(scene) {}

  /// Reads the materials that have names.
  void readNamed(const Value& value);

  /// The index of a shape's material: of a name, or of a material that it has for itself.
  [[nodiscard]] std::uint32_t indexOf(const Value& value);

  /// That of shapes without a material.
  [[nodiscard]] std::uint32_t defaultIndex();

 private:
  [[nodiscard]] Material readMaterial(const Value& value);
  [[nodiscard]] ColourSource readColour(const Value& value, std::string_view key);
  [[nodiscard]] NumberSource readNumber(const Value& value, std::string_view key);
  std::uint32_t add(Material material);

  const JsonText& text_;
  TextureTable& textures_;
  SceneDescription& scene_;
  std::map<std::string, std::uint32_t> indices_;
  std::optional<std::uint32_t> default_;
};

}  // namespace planetree::scene::json_format
