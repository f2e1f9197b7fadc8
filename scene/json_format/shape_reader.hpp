#pragma once

#include "scene/json_format/json_text.hpp"
#include "scene/json_format/json_value.hpp"
#include "scene/json_format/material_table.hpp"
#include "scene/json_format/model_table.hpp"
#include "scene/json_format/value_reader.hpp"
#include "scene/scene_description.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace planetree::scene::json_format {

/// What may be placed in all, counting the faces of meshes. A small file can place a large model
/// very often.
inline constexpr std::size_t kMaxPlacedObjectCount = std::size_t{1} << 28u;

/// Reads shapes, models and groups, and places them in the scene.
class ShapeReader {
 public:
  ShapeReader(const JsonText& text, MaterialTable& materials, ModelTable& models,
              SceneDescription& scene) noexcept
      : text_(text), materials_(materials), models_(models), scene_(scene) {}

  /// Reads a list of shapes.
  void readAll(const Value& value) { readList(value, {}); }

 private:
  /// What shapes have from the groups around them.
  struct Surroundings {
    Affine placement;
    std::optional<std::uint32_t> material;
  };

  void readList(const Value& value, const Surroundings& around);
  void readShape(const Value& value, const Surroundings& around);
  void readModel(const Value& value, const ObjectReader& object, const Surroundings& around);
  /// What is around it, with the position and the material that the object itself has.
  [[nodiscard]] Surroundings at(const ObjectReader& object, const Surroundings& around);
  [[nodiscard]] Affine transformOf(const ObjectReader& object) const;
  [[nodiscard]] PlacedShape readSolid(const ObjectSyntax& syntax, const ObjectReader& object) const;
  [[nodiscard]] Affine readFit(const Value& value, const Box3& bounds) const;
  void place(const Value& value, PlacedShape shape);

  const JsonText& text_;
  MaterialTable& materials_;
  ModelTable& models_;
  SceneDescription& scene_;
  std::size_t placedCount_ = 0;
};

}  // namespace planetree::scene::json_format
