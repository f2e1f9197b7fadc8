#include "scene/json_format/material_table.hpp"

#include "scene/json_format/value_reader.hpp"
#include "scene/value_ranges.hpp"

#include <array>
#include <utility>
#include <vector>

namespace planetree::scene::json_format {

namespace {

/// Of highlights, unless a material says more: as of paint.
constexpr double kUsualShininess = 32.0;

}  // namespace

void MaterialTable::readNamed(const Value& value) {
  for (const Member& member : objectOf(text_, value, "\"materials\"")) {
    Material material = readMaterial(member.value);
    material.name = member.key;
    indices_.emplace(member.key, add(std::move(material)));
  }
}

std::uint32_t MaterialTable::indexOf(const Value& value) {
  if (std::holds_alternative<Object>(value.content))
    return add(readMaterial(value));
  if (!std::holds_alternative<std::string>(value.content))
    throw wrongType(text_, value, "\"material\"", "the name of a material or an object");
  const auto& name = std::get<std::string>(value.content);
  if (const auto found = indices_.find(name); found != indices_.end())
    return found->second;
  std::vector<std::string> known;
  for (const auto& entry : indices_)
    known.push_back(entry.first);
  throw text_.malformed(value.offset, "there is no material " + inQuotes(name),
                        adviceOf(name, known));
}

std::uint32_t MaterialTable::defaultIndex() {
  if (!default_) {
    const ColourSource grey{.value = {0.8, 0.8, 0.8}};
    default_ = add({.ambient = grey, .diffuse = grey});
  }
  return *default_;
}

Material MaterialTable::readMaterial(const Value& value) {
  const ObjectReader object(text_, value, kMaterialSyntax);
  Material material{.shininess = {.value = kUsualShininess}};
  const std::array<std::pair<std::string_view, ColourSource*>, 6> colours = {
      {{"emissive", &material.emissive},
       {"ambient", &material.ambient},
       {"diffuse", &material.diffuse},
       {"specular", &material.specular},
       {"reflective", &material.reflective},
       {"transmissive", &material.transmissive}}};
  for (const auto& [key, source] : colours) {
    if (const Value* colour = object.find(key))
      *source = readColour(*colour, key);
  }
  // What a surface scatters it scatters of ambient light too, as a rule.
  if (object.find("ambient") == nullptr)
    material.ambient = material.diffuse;
  if (const Value* index = object.find("index")) {
    material.index = readNumber(*index, "index");
    if (!isPositive(material.index.value)) {
      throw text_.malformed(index->offset, "\"index\" must be greater than 0",
                            "Give an index of refraction, as 1.5 for glass.");
    }
  }
  if (const Value* shininess = object.find("shininess"))
    material.shininess = readNumber(*shininess, "shininess");
  return material;
}

ColourSource MaterialTable::readColour(const Value& value, std::string_view key) {
  if (!std::holds_alternative<Object>(value.content))
    return {.value = colourOf(text_, value, inQuotes(key))};
  const ObjectReader object(text_, value, kTexturedColourSyntax);
  const Value* factor = object.find("factor");
  return {.value = factor == nullptr ? Vec3d{1, 1, 1} : colourOf(text_, *factor, "\"factor\""),
          .texture = textures_.read(object.at("texture"))};
}

NumberSource MaterialTable::readNumber(const Value& value, std::string_view key) {
  if (!std::holds_alternative<Object>(value.content))
    return {.value = amountOf(text_, value, inQuotes(key))};
  const ObjectReader object(text_, value, kTexturedNumberSyntax);
  const Value* factor = object.find("factor");
  return {.value = factor == nullptr ? 1.0 : amountOf(text_, *factor, "\"factor\""),
          .texture = textures_.read(object.at("texture"))};
}

std::uint32_t MaterialTable::add(Material material) {
  scene_.materials.push_back(std::move(material));
  return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

}  // namespace planetree::scene::json_format
