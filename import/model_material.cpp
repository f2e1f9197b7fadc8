#include "import/model_material.hpp"

#include <algorithm>
#include <cmath>

namespace planetree::importing {
namespace {

using scene::ColourSource;
using scene::Material;

constexpr Vec3d kWhite{1, 1, 1};

double most(const Vec3d& colour) noexcept {
  return std::max({colour.x, colour.y, colour.z});
}

ColourSource scaled(const ColourSource& colour, double factor) noexcept {
  return {colour.value * factor, factor > 0.0 ? colour.texture : std::nullopt};
}

/// The transfer function of IEC 61966-2-1 (sRGB): from an amount of light to what stands for it in
/// a picture.
double encoded(double light) noexcept {
  if (light <= 0.0031308)
    return 12.92 * light;
  return 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

Vec3d encoded(const Vec3d& light) noexcept {
  return {encoded(light.x), encoded(light.y), encoded(light.z)};
}

/// The mean of one channel of a texture.
double meanOf(const scene::Texture& texture, float Vec3f::*channel) {
  double sum = 0.0;
  for (std::uint32_t y = 0; y < texture.height(); ++y) {
    for (std::uint32_t x = 0; x < texture.width(); ++x)
      sum += static_cast<double>(texture.texel(x, y).*channel);
  }
  const double count = static_cast<double>(texture.width()) * texture.height();
  return count > 0.0 ? sum / count : 1.0;
}

/// What a material says, without what cannot be.
class Sayings {
 public:
  Sayings(const ModelMaterial& material, std::span<const scene::Texture> textures)
      : material_(material), textures_(textures) {}

  [[nodiscard]] std::optional<Vec3d> colour(MaterialProperty property) const noexcept {
    const std::optional<Vec3d>& value = material_.value(property);
    if (!value || !isSound(value->x) || !isSound(value->y) || !isSound(value->z))
      return std::nullopt;
    return value;
  }

  [[nodiscard]] std::optional<double> number(MaterialProperty property) const noexcept {
    const std::optional<Vec3d>& value = material_.value(property);
    return value && isSound(value->x) ? std::optional(value->x) : std::nullopt;
  }
  [[nodiscard]] double number(MaterialProperty property, double otherwise) const noexcept {
    return number(property).value_or(otherwise);
  }
  /// A number from 0 to 1.
  [[nodiscard]] double part(MaterialProperty property, double otherwise) const noexcept {
    return std::min(number(property, otherwise), 1.0);
  }

  [[nodiscard]] std::optional<std::uint32_t> texture(MaterialProperty property) const noexcept {
    return material_.texture(property);
  }

  /// A part, times the mean of its texture.
  [[nodiscard]] double meanPart(MaterialProperty property, double otherwise,
                                float Vec3f::*channel) const {
    const auto index = texture(property);
    const double factor = part(property, otherwise);
    return index && *index < textures_.size() ? factor * meanOf(textures_[*index], channel)
                                              : factor;
  }

 private:
  /// Far above what a colour can be, and far below where sums of them overflow.
  static bool isSound(double x) noexcept { return x >= 0.0 && x <= 1e9; }

  const ModelMaterial& material_;
  std::span<const scene::Texture> textures_;
};

/// The index of refraction, which below that of a vacuum is none.
double indexOf(const Sayings& says, double otherwise) noexcept {
  const double index = says.number(MaterialProperty::RefractiveIndex, otherwise);
  return index >= 1.0 ? index : otherwise;
}

/// How MTL files number their illumination models: which of them see through the surface with
/// rays, and which bend them; from 3 on all but 10 reflect.
bool isGlass(double illumination) noexcept {
  return illumination == 4 || illumination == 6 || illumination == 7 || illumination == 9;
}
bool bends(double illumination) noexcept {
  return illumination == 6 || illumination == 7;
}
bool reflects(double illumination) noexcept {
  return illumination >= 3 && illumination < 10;
}

void translateTransparency(const Sayings& says, Material& result) {
  const double opacity = says.part(MaterialProperty::Opacity, 1.0);
  const double illumination = says.number(MaterialProperty::Illumination, -1.0);
  Vec3d filter = kWhite;
  if (illumination >= 0.0)
    filter = says.colour(MaterialProperty::Transparent).value_or(kWhite);
  if (opacity < 1.0)
    result.transmissive.value = filter * (1.0 - opacity);
  else if (bends(illumination))
    result.transmissive.value = filter;
  // What lies behind shows as much as the surface itself does not.
  result.diffuse = scaled(result.diffuse, opacity);
  result.ambient = scaled(result.ambient, opacity);
  result.index.value = illumination < 0.0 || isGlass(illumination) ? indexOf(says, 1.0) : 1.0;
}

void translateReflection(const Sayings& says, Material& result) {
  const auto illumination = says.number(MaterialProperty::Illumination);
  if (illumination && reflects(*illumination)) {
    result.reflective = result.specular;
    return;
  }
  const double amount = says.part(MaterialProperty::Reflectivity, 0.0);
  result.reflective.value = says.colour(MaterialProperty::Reflective).value_or(kWhite) * amount;
}

/// A colour with its map. A map times black is nothing, and nobody would draw one for that: where a
/// file has a map and black, or no colour, the map stands for itself.
ColourSource mapped(const Sayings& says, MaterialProperty property, const Vec3d& otherwise) {
  const auto map = says.texture(property);
  const Vec3d colour = says.colour(property).value_or(otherwise);
  return {map && most(colour) == 0.0 ? kWhite : colour, map};
}

Material translateClassic(const Sayings& says) {
  Material result;
  result.diffuse = mapped(says, MaterialProperty::Diffuse, kWhite * 0.6);
  if (says.number(MaterialProperty::Illumination) == 0.0) {
    Material unlit;
    unlit.emissive = result.diffuse;
    return unlit;
  }
  result.ambient = mapped(says, MaterialProperty::Ambient, result.diffuse.value);
  if (!result.ambient.texture)
    result.ambient.texture = result.diffuse.texture;
  result.specular = mapped(says, MaterialProperty::Specular, Vec3d{});
  result.emissive = mapped(says, MaterialProperty::Emissive, Vec3d{});
  translateReflection(says, result);
  translateTransparency(says, result);
  result.shininess.value = says.number(MaterialProperty::Shininess, 0.0);
  result.specular = scaled(result.specular, says.number(MaterialProperty::ShininessStrength, 1.0));
  // Without an exponent the highlight would cover all, from every side.
  if (result.shininess.value == 0.0)
    result.specular = {};
  return result;
}

/// The surface of the metallic-roughness model. See docs/model_files.md for the reasons.
struct PhysicalSurface {
  ColourSource base;      ///< as a picture has it
  Vec3d straight;         ///< what it reflects of light that falls straight on it
  double metallic = 0.0;  ///< 0 or 1, and between where a texture has both
  double roughness = 1.0;
};

PhysicalSurface physicalSurface(const Sayings& says, double index) {
  PhysicalSurface surface;
  const bool isLinear = says.number(MaterialProperty::LinearColour).has_value();
  const Vec3d base = says.colour(MaterialProperty::Diffuse).value_or(kWhite);
  surface.base = {isLinear ? encoded(base) : base, says.texture(MaterialProperty::Diffuse)};
  if (const auto glossiness = says.number(MaterialProperty::Glossiness)) {
    surface.roughness = 1.0 - std::min(*glossiness, 1.0);
    surface.straight = says.colour(MaterialProperty::Specular).value_or(kWhite);
    return surface;
  }
  // glTF: blue is metal and green is roughness; images of one of them are grey.
  surface.metallic = says.meanPart(MaterialProperty::Metallic, 1.0, &Vec3f::z);
  surface.roughness = says.meanPart(MaterialProperty::Roughness, 1.0, &Vec3f::y);
  // Fresnel's equations at right angles.
  const double ratio = (index - 1.0) / (index + 1.0);
  surface.straight =
      kWhite * (ratio * ratio * (1.0 - surface.metallic)) + surface.base.value * surface.metallic;
  return surface;
}

/// The highlight of Phong that is as wide and as bright as that of a rough surface.
void setHighlight(const PhysicalSurface& surface, Material& result) {
  // Narrower ones would fall between the pixels of a picture.
  constexpr double kNarrowest = 1e-3;
  const double alpha = surface.roughness * surface.roughness;
  const double squared = std::max(alpha * alpha, kNarrowest);
  result.shininess.value = std::max((1.0 / squared - 1.0) / 2.0, 1.0);
  result.specular.value = surface.straight * (0.25 / squared);
  const double brightest = most(result.specular.value);
  if (brightest > 1.0)
    result.specular.value = result.specular.value / brightest;
  if (surface.metallic == 1.0)
    result.specular.texture = surface.base.texture;
}

Material translatePhysical(const Sayings& says) {
  constexpr double kGlass = 1.5;  // what glTF says where a file says nothing
  const auto givenIndex = says.number(MaterialProperty::RefractiveIndex);
  const double index = indexOf(says, kGlass);
  const PhysicalSurface surface = physicalSurface(says, index);
  if (says.number(MaterialProperty::Unlit)) {
    Material unlit;
    unlit.emissive = surface.base;
    return unlit;
  }
  const double smoothness = 1.0 - surface.roughness;
  const double transmission =
      says.part(MaterialProperty::Transmission, 0.0) * (1.0 - surface.metallic);
  const double opacity = says.part(MaterialProperty::Opacity, 1.0);
  const double mirror = surface.metallic * smoothness;

  Material result;
  const double scattered = (1.0 - mirror) * (1.0 - transmission) * opacity;
  result.diffuse = scaled(surface.base, scattered);
  result.ambient = result.diffuse;
  setHighlight(surface, result);
  if (transmission > 0.0) {
    result.reflective.value = surface.straight * smoothness;
    result.transmissive = scaled(surface.base, transmission * opacity);
  } else {
    result.reflective = scaled(surface.base, mirror);
  }
  result.transmissive.value = result.transmissive.value + kWhite * (1.0 - opacity);
  // Without a volume a surface is a thin sheet, behind which rays go on as they came.
  const bool isSolid = givenIndex || says.number(MaterialProperty::Thickness, 0.0) > 0.0;
  result.index.value = transmission > 0.0 && isSolid ? index : 1.0;

  const bool isLinear = says.number(MaterialProperty::LinearColour).has_value();
  const Vec3d emissive = says.colour(MaterialProperty::Emissive).value_or(Vec3d{});
  result.emissive.value = isLinear ? encoded(emissive) : emissive;
  if (most(emissive) > 0.0)
    result.emissive.texture = says.texture(MaterialProperty::Emissive);
  return result;
}

}  // namespace

Material translateMaterial(const ModelMaterial& material,
                           std::span<const scene::Texture> textures) {
  const Sayings says(material, textures);
  const bool isPhysical = says.number(MaterialProperty::Metallic).has_value() ||
                          says.number(MaterialProperty::Roughness).has_value();
  Material result = isPhysical ? translatePhysical(says) : translateClassic(says);
  result.name = material.name;
  return result;
}

Material clay() {
  Material result;
  result.name = "clay";
  result.diffuse.value = {0.8, 0.78, 0.74};
  result.ambient.value = result.diffuse.value;
  return result;
}

}  // namespace planetree::importing
