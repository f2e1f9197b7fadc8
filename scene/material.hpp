#pragma once

#include <planetree/geometry/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace planetree::scene {

/// A colour, or an image that holds one for every place of a surface.
struct ColourSource {
  Vec3d value{0, 0, 0};                       ///< a factor where there is a texture
  std::optional<std::uint32_t> texture = {};  ///< index in `SceneDescription::textures`

  friend bool operator==(const ColourSource&, const ColourSource&) noexcept = default;
};

/// A number, or an image: its intensity times `value`.
struct NumberSource {
  double value = 0.0;
  std::optional<std::uint32_t> texture = {};

  friend bool operator==(const NumberSource&, const NumberSource&) noexcept = default;
};

/// The surface of Whitted, "An improved illumination model for shaded display", CACM 1980, with the
/// specular term of Phong, "Illumination for computer generated pictures", CACM 1975. The outermost
/// default is all zero: black.
struct Material {
  std::string name = {};
  ColourSource emissive = {};
  ColourSource ambient = {};
  ColourSource diffuse = {};
  ColourSource specular = {};
  ColourSource reflective = {};
  ColourSource transmissive = {};  ///< the part of light that passes; refracted by `index`
  NumberSource index{1.0};         ///< of refraction, relative to what is outside
  NumberSource shininess{0.0};     ///< the exponent of the highlight

  friend bool operator==(const Material&, const Material&) = default;
};

/// A material at one place of a surface.
struct MaterialSample {
  Vec3d emissive, ambient, diffuse, specular, reflective, transmissive;
  double index = 1.0;
  double shininess = 0.0;
};

}  // namespace planetree::scene
