#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

/// Every word of the `.ray` format that means something: what the readers know, errors advise and
/// tests go through.
namespace planetree::scene::ray_format {

/// What a keyword means that stands in a block for a second time.
enum class Repeats : std::uint8_t {
  Remarked,  ///< the later one counts
  Refused,
};

/// Something between braces: the keyword before them, and those that may stand in it.
struct BlockSyntax {
  static constexpr std::size_t kMostKeywords = 16;

  std::string_view name;  ///< "camera"
  std::span<const std::string_view> keywords;
  Repeats repeats = Repeats::Remarked;
};

inline constexpr std::array<std::string_view, 6> kCameraKeywords = {
    "position", "viewdir", "updir", "quaternian", "fov", "aspectratio"};
inline constexpr std::array<std::string_view, 1> kAmbientLightKeywords = {"color"};
inline constexpr std::array<std::string_view, 5> kPointLightKeywords = {
    "position", "color", "constant_attenuation_coeff", "linear_attenuation_coeff",
    "quadratic_attenuation_coeff"};
inline constexpr std::array<std::string_view, 2> kDirectionalLightKeywords = {"direction", "color"};
inline constexpr std::array<std::string_view, 9> kMaterialKeywords = {
    "emissive",     "ambient", "diffuse",   "specular", "reflective",
    "transmissive", "index",   "shininess", "name"};
inline constexpr std::array<std::string_view, 2> kPlainShapeKeywords = {"material", "name"};
inline constexpr std::array<std::string_view, 6> kConeKeywords = {
    "material", "name", "capped", "height", "bottom_radius", "top_radius"};
inline constexpr std::array<std::string_view, 8> kMeshKeywords = {
    "material", "name", "points", "faces", "normals", "materials", "gennormals", "texture_uv"};

inline constexpr std::array<BlockSyntax, 12> kBlocks = {{
    {"camera", kCameraKeywords},
    {"ambient_light", kAmbientLightKeywords, Repeats::Refused},
    {"point_light", kPointLightKeywords, Repeats::Refused},
    {"directional_light", kDirectionalLightKeywords, Repeats::Refused},
    {"material", kMaterialKeywords},
    {"sphere", kPlainShapeKeywords},
    {"box", kPlainShapeKeywords},
    {"square", kPlainShapeKeywords},
    {"cylinder", kPlainShapeKeywords},
    {"cone", kConeKeywords},
    {"trimesh", kMeshKeywords, Repeats::Refused},
    {"polymesh", kMeshKeywords, Repeats::Refused},
}};
static_assert(std::all_of(kBlocks.begin(), kBlocks.end(), [](const BlockSyntax& block) {
  return block.keywords.size() <= BlockSyntax::kMostKeywords;
}));

/// The block of this name, which must be there.
[[nodiscard]] constexpr const BlockSyntax& blockNamed(std::string_view name) {
  return *std::find_if(kBlocks.begin(), kBlocks.end(),
                       [&](const BlockSyntax& block) { return block.name == name; });
}

inline constexpr std::array<std::string_view, 7> kShapeKeywords = {
    "sphere", "box", "square", "cylinder", "cone", "trimesh", "polymesh"};
inline constexpr std::array<std::string_view, 4> kTransformKeywords = {"translate", "rotate",
                                                                       "scale", "transform"};

// Words that stand behind keywords.
inline constexpr std::string_view kTrue = "true";
inline constexpr std::string_view kFalse = "false";
inline constexpr std::string_view kMap = "map";
inline constexpr std::array<std::string_view, 3> kValueWords = {kTrue, kFalse, kMap};

/// Keywords of blocks that may be written in another way, which comes second.
inline constexpr std::array<std::pair<std::string_view, std::string_view>, 1> kOtherSpellings = {
    {{"color", "colour"}}};

/// Whether a word of a scene is this keyword of a block.
[[nodiscard]] constexpr bool isSpelling(std::string_view word, std::string_view keyword) {
  return word == keyword ||
         std::any_of(kOtherSpellings.begin(), kOtherSpellings.end(), [&](const auto& pair) {
           return pair.first == keyword && pair.second == word;
         });
}

}  // namespace planetree::scene::ray_format
