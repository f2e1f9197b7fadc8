#include "scene/json_format/object_syntax.hpp"

#include <array>

namespace planetree::scene::json_format {

namespace {

template <class... Keys>
constexpr std::array<std::string_view, sizeof...(Keys)> keys(Keys... names) {
  return {std::string_view(names)...};
}

/// The keys of a shape, after those that all shapes have.
template <class... Keys>
constexpr auto shapeKeys(Keys... names) {
  return keys("name", "material", "transform", "position", names...);
}

constexpr auto kType = keys("type");

constexpr auto kSceneOptional = keys("$schema", "title", "camera", "ambient_light", "lights",
                                     "materials", "background", "shapes");
constexpr auto kCameraRequired = keys("position", "look_at");
constexpr auto kCameraOptional = keys("up", "fov", "aspect_ratio");
constexpr auto kPointLightRequired = keys("type", "position", "colour");
constexpr auto kPointLightOptional = keys("constant", "linear", "quadratic");
constexpr auto kDirectionalLightRequired = keys("type", "direction", "colour");
constexpr auto kMaterialOptional = keys("emissive", "ambient", "diffuse", "specular", "reflective",
                                        "transmissive", "index", "shininess");
constexpr auto kTextureRequired = keys("texture");
constexpr auto kTextureOptional = keys("factor");
constexpr auto kCubeMapRequired = keys("posx", "negx", "posy", "negy", "posz", "negz");
constexpr auto kSphereOptional = shapeKeys("radius");
constexpr auto kBoxOptional = shapeKeys("size");
constexpr auto kSquareOptional = shapeKeys("size");
constexpr auto kCylinderOptional = shapeKeys("radius", "height", "capped");
constexpr auto kConeOptional = shapeKeys("bottom_radius", "top_radius", "height", "capped");
constexpr auto kModelRequired = keys("type", "file");
constexpr auto kModelOptional = shapeKeys("fit");
constexpr auto kFitRequired = keys("lower", "upper");
constexpr auto kGroupRequired = keys("type", "children");
constexpr auto kGroupOptional = shapeKeys();
constexpr auto kTransformStepOptional = keys("translate", "rotate", "scale", "matrix");
constexpr auto kRotationRequired = keys("axis", "degrees");

}  // namespace

const ObjectSyntax kSceneSyntax{"scene", {}, kSceneOptional};
const ObjectSyntax kCameraSyntax{"camera", kCameraRequired, kCameraOptional};
const ObjectSyntax kPointLightSyntax{"point light", kPointLightRequired, kPointLightOptional};
const ObjectSyntax kDirectionalLightSyntax{"directional light", kDirectionalLightRequired, {}};
const ObjectSyntax kMaterialSyntax{"material", {}, kMaterialOptional};
const ObjectSyntax kTexturedColourSyntax{"textured colour", kTextureRequired, kTextureOptional};
const ObjectSyntax kTexturedNumberSyntax{"textured number", kTextureRequired, kTextureOptional};
const ObjectSyntax kCubeMapSyntax{"cube map", kCubeMapRequired, {}};
const ObjectSyntax kSphereSyntax{"sphere", kType, kSphereOptional};
const ObjectSyntax kBoxSyntax{"box", kType, kBoxOptional};
const ObjectSyntax kSquareSyntax{"square", kType, kSquareOptional};
const ObjectSyntax kCylinderSyntax{"cylinder", kType, kCylinderOptional};
const ObjectSyntax kConeSyntax{"cone", kType, kConeOptional};
const ObjectSyntax kModelSyntax{"model", kModelRequired, kModelOptional};
const ObjectSyntax kFitSyntax{"fit", kFitRequired, {}};
const ObjectSyntax kGroupSyntax{"group", kGroupRequired, kGroupOptional};
const ObjectSyntax kTransformStepSyntax{"transform step", {}, kTransformStepOptional};
const ObjectSyntax kRotationSyntax{"rotation", kRotationRequired, {}};

std::span<const ObjectSyntax* const> objectSyntaxes() noexcept {
  static constexpr std::array kAll = {&kSceneSyntax,
                                      &kCameraSyntax,
                                      &kPointLightSyntax,
                                      &kDirectionalLightSyntax,
                                      &kMaterialSyntax,
                                      &kTexturedColourSyntax,
                                      &kTexturedNumberSyntax,
                                      &kCubeMapSyntax,
                                      &kSphereSyntax,
                                      &kBoxSyntax,
                                      &kSquareSyntax,
                                      &kCylinderSyntax,
                                      &kConeSyntax,
                                      &kModelSyntax,
                                      &kFitSyntax,
                                      &kGroupSyntax,
                                      &kTransformStepSyntax,
                                      &kRotationSyntax};
  return kAll;
}

}  // namespace planetree::scene::json_format
