#include "scene/ray_format/shape_reader.hpp"

#include "scene/ray_format/mesh_reader.hpp"

#include <cmath>

namespace planetree::scene::ray_format {
namespace {

/// What every shape may have; false for other keywords.
bool readCommon(TokenReader& tokens, const Token& keyword, MaterialReader& materials,
                const Surroundings& surroundings, PlacedShape& placed) {
  if (keyword.text == "material") {
    placed.material = materials.readAssignment(tokens, keyword, surroundings.material);
    return true;
  }
  if (keyword.text == "name") {
    placed.name = tokens.nameOf("a shape").text;
    return true;
  }
  return false;
}

void readCone(TokenReader& tokens, const Token& cone, MaterialReader& materials,
              const Surroundings& surroundings, PlacedShape& placed) {
  ConeShape shape = {.height = 1.0, .bottomRadius = 1.0, .topRadius = 0.0, .isCapped = true};
  tokens.block(blockNamed(cone.text), [&](const Token& keyword) {
    if (readCommon(tokens, keyword, materials, surroundings, placed))
      return;
    if (keyword.text == "capped") {
      tokens.expectEquals(keyword);
      shape.isCapped = tokens.boolean();
    } else if (keyword.text == "height") {
      shape.height = tokens.numberOf(keyword);
    } else if (keyword.text == "bottom_radius") {
      shape.bottomRadius = std::fabs(tokens.numberOf(keyword));
    } else {
      shape.topRadius = std::fabs(tokens.numberOf(keyword));
    }
  });
  if (shape.height == 0.0)
    throw tokens.malformed(cone.place, "the height of the cone is 0", "Give it another height");
  if (shape.bottomRadius == 0.0 && shape.topRadius == 0.0) {
    throw tokens.malformed(cone.place, "both radii of the cone are 0",
                           "Give it another bottom_radius or top_radius");
  }
  placed.shape = shape;
}

ShapeDescription plainShape(std::string_view keyword) {
  if (keyword == "box")
    return UnitBox{};
  if (keyword == "square")
    return UnitSquare{};
  if (keyword == "cylinder")
    return UnitCylinder{};
  return UnitSphere{};
}

}  // namespace

PlacedShape readShape(TokenReader& tokens, const Token& keyword, MaterialReader& materials,
                      const Surroundings& surroundings) {
  PlacedShape placed;
  placed.placement = surroundings.placement;
  placed.material = surroundings.material;
  const auto readCommonEntry = [&](const Token& entry) {
    return readCommon(tokens, entry, materials, surroundings, placed);
  };
  if (keyword.text == "trimesh" || keyword.text == "polymesh") {
    placed.shape = MeshReader(tokens, materials, placed.material).read(keyword, readCommonEntry);
  } else if (keyword.text == "cone") {
    readCone(tokens, keyword, materials, surroundings, placed);
  } else {
    tokens.block(blockNamed(keyword.text),
                 [&](const Token& entry) { static_cast<void>(readCommonEntry(entry)); });
    placed.shape = plainShape(keyword.text);
  }
  return placed;
}

}  // namespace planetree::scene::ray_format
