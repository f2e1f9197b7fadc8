#include "scene/ray_format/material_reader.hpp"

#include "support/text_lines.hpp"

#include <array>
#include <utility>
#include <vector>

namespace planetree::scene::ray_format {
namespace {

using planetree::detail::quoted;

constexpr const BlockSyntax& kSyntax = blockNamed("material");

/// A mapped shininess is this for white.
constexpr double kLargestShininess = 128.0;

ColourSource* colourOf(Material& material, std::string_view keyword) {
  const std::array<std::pair<std::string_view, ColourSource*>, 6> colours = {{
      {"emissive", &material.emissive},
      {"ambient", &material.ambient},
      {"diffuse", &material.diffuse},
      {"specular", &material.specular},
      {"reflective", &material.reflective},
      {"transmissive", &material.transmissive},
  }};
  for (const auto& [name, colour] : colours) {
    if (name == keyword)
      return colour;
  }
  return nullptr;
}

}  // namespace

MaterialReader::MaterialReader(SceneDescription& scene, TextureReader& textures)
    : scene_(scene), textures_(textures) {
  scene_.materials.emplace_back();
}

std::uint32_t MaterialReader::readAssignment(TokenReader& tokens, const Token& keyword,
                                             std::uint32_t surrounding) {
  tokens.expectEquals(keyword);
  return read(tokens, surrounding);
}

std::uint32_t MaterialReader::read(TokenReader& tokens, std::uint32_t surrounding) {
  if (tokens.peek().is('{'))
    return readBlock(tokens, surrounding);
  if (tokens.peek().isName())
    return find(tokens, tokens.take());
  throw tokens.unexpected(tokens.peek(), "'{' or the name of a material",
                          "Write material = { ... } or material = name");
}

std::uint32_t MaterialReader::readBlock(TokenReader& tokens, std::uint32_t surrounding) {
  Material material = scene_.materials[surrounding];
  const std::string surroundingName = std::exchange(material.name, "");
  Token name;
  tokens.block(kSyntax, [&](const Token& keyword) {
    if (keyword.text == "name") {
      name = tokens.nameOf("a material");
      return;
    }
    tokens.expectEquals(keyword);
    if (keyword.text == "index") {
      material.index =
          readNumber(tokens, 1.0, [&] { return tokens.positiveNumber("an index of refraction"); });
    } else if (keyword.text == "shininess") {
      material.shininess =
          readNumber(tokens, kLargestShininess, [&] { return tokens.amount("a shininess"); });
    } else {
      *colourOf(material, keyword.text) = readColour(tokens);
    }
  });

  const bool isNamed = name.isName();
  if (!isNamed) {
    // A scene may say `material = {}` a million times.
    material.name = surroundingName;
    if (material == scene_.materials[surrounding])
      return surrounding;
    material.name.clear();
  }
  const auto index = static_cast<std::uint32_t>(scene_.materials.size());
  if (isNamed) {
    material.name = name.text;
    const auto [entry, isNew] = named_.try_emplace(material.name, Named{index, name.place});
    if (!isNew) {
      throw tokens.malformed(name.place,
                             "the material " + quoted(name.text) +
                                 " is defined a second time, after " +
                                 describe(entry->second.place),
                             "Give one of them another name");
    }
  }
  scene_.materials.push_back(std::move(material));
  return index;
}

ColourSource MaterialReader::readColour(TokenReader& tokens) {
  if (tokens.peek().isWord(kMap))
    return {{1, 1, 1}, readMap(tokens)};
  if (!tokens.peek().is('(')) {
    throw tokens.unexpected(tokens.peek(), "a colour or a map",
                            "Write three numbers, (red, green, blue), or map(\"file.png\")");
  }
  return {tokens.colour(), {}};
}

template <class ReadPlain>
NumberSource MaterialReader::readNumber(TokenReader& tokens, double factorOfMap,
                                        ReadPlain readPlain) {
  if (tokens.peek().isWord(kMap))
    return {factorOfMap, readMap(tokens)};
  if (tokens.peek().kind != TokenKind::Number) {
    throw tokens.unexpected(tokens.peek(), "a number or a map",
                            "Write a number such as 1.5, or map(\"file.png\")");
  }
  return {readPlain(), {}};
}

std::uint32_t MaterialReader::readMap(TokenReader& tokens) {
  constexpr std::string_view kAdvice = "Write map(\"file.png\")";
  tokens.take();
  tokens.expect('(', "behind \"map\"", kAdvice);
  if (!tokens.peek().isName())
    throw tokens.unexpected(tokens.peek(), "the name of an image file", std::string(kAdvice));
  const Token file = tokens.take();
  tokens.expect(')', "behind the name of the image file", kAdvice);
  return textures_.read(tokens, file);
}

std::uint32_t MaterialReader::find(const TokenReader& tokens, const Token& name) const {
  const auto entry = named_.find(name.text);
  if (entry != named_.end())
    return entry->second.index;
  // Among a million names, the search for the nearest would take long.
  constexpr std::size_t kMostNames = 1000;
  std::vector<std::string_view> names;
  for (auto known = named_.begin(); known != named_.end() && names.size() < kMostNames; ++known)
    names.push_back(known->first);
  throw tokens.malformed(name.place, "there is no material " + quoted(name.text) + " so far",
                         adviseNearest(name, names, "Define it before it is used"));
}

}  // namespace planetree::scene::ray_format
