#include "scene/ray_format/light_reader.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace planetree::scene::ray_format {
namespace {

constexpr const BlockSyntax& kAmbientSyntax = blockNamed("ambient_light");
constexpr const BlockSyntax& kDirectionalSyntax = blockNamed("directional_light");
constexpr const BlockSyntax& kPointSyntax = blockNamed("point_light");

constexpr std::string_view kCoefficient = "a coefficient of attenuation";

Vec3d require(const TokenReader& tokens, const std::optional<Vec3d>& given, const Token& light,
              const std::string& keyword) {
  if (given)
    return *given;
  throw tokens.malformed(light.place,
                         "the \"" + std::string(light.text) + "\" has no \"" + keyword + "\"",
                         "Add " + keyword + " = (..., ..., ...)");
}

}  // namespace

void readAmbientLight(TokenReader& tokens, const Token& light, SceneDescription& scene) {
  std::optional<Vec3d> colour;
  tokens.block(kAmbientSyntax, [&](const Token& keyword) { colour = tokens.colourOf(keyword); });
  scene.ambientLight = scene.ambientLight + require(tokens, colour, light, "color");
}

void readDirectionalLight(TokenReader& tokens, const Token& light, SceneDescription& scene) {
  std::optional<Vec3d> direction;
  std::optional<Vec3d> colour;
  tokens.block(kDirectionalSyntax, [&](const Token& keyword) {
    if (keyword.text == "direction")
      direction = tokens.vectorOf(keyword);
    else
      colour = tokens.colourOf(keyword);
    if (direction == Vec3d{0, 0, 0}) {
      throw tokens.malformed(keyword.place, "the \"direction\" is (0, 0, 0)",
                             "Say in which direction the light travels");
    }
  });
  scene.directionalLights.push_back(
      {require(tokens, direction, light, "direction"), require(tokens, colour, light, "color")});
}

void readPointLight(TokenReader& tokens, const Token& light, SceneDescription& scene) {
  PointLight result;
  // The format's own defaults, whichever those of the structure are.
  result.constant = 0.0;
  result.linear = 0.0;
  result.quadratic = 1.0;
  std::optional<Vec3d> position;
  std::optional<Vec3d> colour;
  tokens.block(kPointSyntax, [&](const Token& keyword) {
    if (keyword.text == "position")
      position = tokens.vectorOf(keyword);
    else if (keyword.text == "color")
      colour = tokens.colourOf(keyword);
    else if (keyword.text == "constant_attenuation_coeff")
      result.constant = tokens.amountOf(keyword, kCoefficient);
    else if (keyword.text == "linear_attenuation_coeff")
      result.linear = tokens.amountOf(keyword, kCoefficient);
    else
      result.quadratic = tokens.amountOf(keyword, kCoefficient);
  });
  result.position = require(tokens, position, light, "position");
  result.colour = require(tokens, colour, light, "color");
  scene.pointLights.push_back(result);
}

}  // namespace planetree::scene::ray_format
