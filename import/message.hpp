#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

/// What `planetree-assimp` tells the process that started it, through its standard output: the
/// greeting, then messages. Both sides are of one build and on one machine, so numbers are as in
/// memory. The reading side trusts none of them.
namespace planetree::importing {

inline constexpr std::string_view kGreeting = "planetree reads\n";

/// The last argument of the program if it is to tell of a scene and not only of its geometry.
inline constexpr std::string_view kSceneRequest = "scene";

enum class MessageKind : std::uint32_t {
  Format,    ///< text: what kind of file it is
  Remark,    ///< text: what assimp warns of
  Mesh,      ///< nothing: the polygons to come refer to the vertices to come
  Vertices,  ///< three doubles for each vertex
  Polygons,  ///< words: the corner count of a polygon, its vertex indices within the mesh, and the
             ///< same for the next one; a polygon may go on in the next message
  Unread,    ///< a 64-bit count of points and lines

  // These are told of scenes only. Textures and materials come before the meshes, meshes before
  // their placements. A colour, point or direction is three doubles.
  Texture,          ///< two words, its width and height, and text, its name; its texels follow
  Texels,           ///< three floats for each, row by row from the top
  Material,         ///< text: its name; what is said of a material is said of the last one
  MaterialValue,    ///< a `MaterialProperty` and a colour; a number is a colour's first part
  MaterialTexture,  ///< a `MaterialProperty` and the index of a texture
  MeshMaterial,     ///< the index of the material of the present mesh
  Normals,          ///< three doubles for each vertex, of all vertices or of none
  Coordinates,      ///< of textures: two doubles for each vertex, of all vertices or of none
  Placement,        ///< the index of a mesh, a `kPlacementNumbers` of doubles, and text: a name
  Light,            ///< a `LightKind`, position, direction, colour, and three parts of attenuation
  Camera,           ///< position, direction, up, the angle of view across in radians, and the width
                    ///< divided by the height, 0 if it is not known

  Failure,  ///< a `FailureKind` and text: why there is no mesh; the last message
  End,      ///< nothing: all has been told; the last message
};

enum class FailureKind : std::uint32_t {
  UnknownFormat,  ///< assimp has no reader for this file
  Malformed,      ///< the reader does not get along with the file; the text is its reason
  OutOfMemory,
  TooLarge,  ///< more vertices than 32 bits can count
};

/// What a file may say of a material. Those from `Metallic` on are of the metallic-roughness model
/// of glTF.
enum class MaterialProperty : std::uint32_t {
  Ambient,
  Diffuse,
  Specular,
  Emissive,
  Reflective,
  Transparent,  ///< the filter of MTL files, their Tf
  Opacity,
  Shininess,
  ShininessStrength,
  Reflectivity,
  RefractiveIndex,
  Illumination,  ///< the number of the illumination model of MTL files
  Metallic,
  Roughness,
  Transmission,
  Glossiness,    ///< of the older specular-glossiness model
  Thickness,     ///< of the volume behind the surface
  Unlit,         ///< there if the colour is to be seen as it is
  LinearColour,  ///< there if the colours measure light; else they are as a picture has them
};
inline constexpr std::size_t kMaterialProperties =
    static_cast<std::size_t>(MaterialProperty::LinearColour) + 1;

enum class LightKind : std::uint32_t {
  Point,
  Directional,
  Spot,
  Area,
  Ambient,
  PhotometricPoint,        ///< its colour is in candela
  PhotometricDirectional,  ///< its colour is in lux
  PhotometricSpot,         ///< in candela
};

/// The images of the three axes and of the origin.
inline constexpr std::size_t kPlacementNumbers = 12;

struct MessageHeader {
  MessageKind kind = MessageKind::End;
  std::uint32_t size = 0;  ///< bytes that follow
};

/// The most bytes of one message. Longer lists are told in several.
inline constexpr std::size_t kMaxMessageSize = std::size_t{1} << 16;

/// The most texels of all textures together.
inline constexpr std::uint64_t kMaxTexels = std::uint64_t{1} << 27;

}  // namespace planetree::importing
