#pragma once

#include <span>
#include <string_view>

/// Which keys the objects of a scene file have: what is read, what is refused, and what
/// data/scenes/scene.schema.json says under these names.
namespace planetree::scene::json_format {

struct ObjectSyntax {
  std::string_view name;  ///< "camera": in errors and in the schema
  std::span<const std::string_view> required;
  std::span<const std::string_view> optional;
};

extern const ObjectSyntax kSceneSyntax;
extern const ObjectSyntax kCameraSyntax;
extern const ObjectSyntax kPointLightSyntax;
extern const ObjectSyntax kDirectionalLightSyntax;
extern const ObjectSyntax kMaterialSyntax;
extern const ObjectSyntax kTexturedColourSyntax;
extern const ObjectSyntax kTexturedNumberSyntax;
extern const ObjectSyntax kCubeMapSyntax;
extern const ObjectSyntax kSphereSyntax;
extern const ObjectSyntax kBoxSyntax;
extern const ObjectSyntax kSquareSyntax;
extern const ObjectSyntax kCylinderSyntax;
extern const ObjectSyntax kConeSyntax;
extern const ObjectSyntax kModelSyntax;
extern const ObjectSyntax kFitSyntax;
extern const ObjectSyntax kGroupSyntax;
extern const ObjectSyntax kTransformStepSyntax;
extern const ObjectSyntax kRotationSyntax;

/// All of the above.
[[nodiscard]] std::span<const ObjectSyntax* const> objectSyntaxes() noexcept;

}  // namespace planetree::scene::json_format
