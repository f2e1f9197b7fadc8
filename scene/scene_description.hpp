#pragma once

#include "scene/affine.hpp"
#include "scene/light.hpp"
#include "scene/material.hpp"
#include "scene/texture.hpp"
#include "scene/view.hpp"

#include <planetree/mesh/triangle_mesh.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What a scene is made of, whichever file it comes from: readers write it, `buildScene` makes a
/// tree and surfaces of it.
namespace planetree::scene {

// The shapes as they are before they are placed; scene files know no other.
struct UnitSphere {};  ///< radius 1 around the origin
struct UnitBox {};     ///< from -0.5 to 0.5 along each axis
struct UnitSquare {};  ///< from -0.5 to 0.5 in the plane z = 0; has two sides
struct UnitCylinder {  ///< radius 1 around z, from z = 0 to 1
  bool isCapped = true;
};
struct ConeShape {  ///< around z, from z = 0 to `height`, which may be negative
  double height = 1.0;
  double bottomRadius = 1.0;  ///< at z = 0; negative radii count as positive
  double topRadius = 0.0;
  bool isCapped = true;  ///< an open cone has two sides
};

/// Triangles with what their corners carry. `normals`, `coordinates` and `vertexMaterials` are
/// empty or have one entry for each position.
struct MeshShape {
  std::vector<Vec3d> positions;
  std::vector<FaceIndices> faces;
  std::vector<Vec3d> normals;                      ///< interpolated over faces; any length
  std::vector<std::array<double, 2>> coordinates;  ///< of textures
  std::vector<std::uint32_t> vertexMaterials;      ///< interpolated over faces
  std::vector<std::uint32_t> faceMaterials;        ///< one for each face, or none
  bool isTwoSided = false;                         ///< shaded on the side the ray comes from
};

using ShapeDescription = std::variant<UnitSphere, UnitBox, UnitSquare, UnitCylinder, ConeShape,
                                      std::shared_ptr<const MeshShape>>;

/// A shape at its place.
struct PlacedShape {
  ShapeDescription shape;
  Affine placement;            ///< from the shape's own space to that of the scene; not singular
  std::uint32_t material = 0;  ///< index in `SceneDescription::materials`
  std::string name = {};
};

/// The cube around the scene: what rays see that hit nothing. All six or none.
struct CubeMap {
  std::array<std::uint32_t, 6> textures;  ///< posx, negx, posy, negy, posz, negz
};

struct SceneDescription {
  std::string name;          ///< of the file, without its folder
  std::optional<View> view;  ///< if the file has a camera
  Vec3d ambientLight{0, 0, 0};
  std::vector<PointLight> pointLights;
  std::vector<DirectionalLight> directionalLights;
  bool hasDefaultLighting = false;  ///< the lights are those of `addDefaultLighting`
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<PlacedShape> shapes;
  std::optional<CubeMap> background;

  /// What is odd about the file but no error, one line each.
  std::vector<std::string> remarks;
};

}  // namespace planetree::scene
