#pragma once

#include "import/message.hpp"

#include "scene/scene_description.hpp"

#include <optional>
#include <span>

namespace planetree::importing {

/// A light as a model file has it, in world coordinates.
struct ModelLight {
  LightKind kind = LightKind::Point;
  Vec3d position;
  Vec3d direction;
  Vec3d colour;
  Vec3d attenuation;  ///< the constant, linear and quadratic parts
};

/// Adds the lights to the scene, whose shapes must be there already; spot and area lights shine to
/// all sides, with a remark. Those with numbers that cannot be are left out, with a remark. Then
/// sets the exposure: see docs/model_files.md.
void addLights(std::span<const ModelLight> lights, scene::SceneDescription& scene);

/// A camera as a model file has it, in world coordinates.
struct ModelCamera {
  Vec3d position;
  Vec3d direction;
  Vec3d up;
  double angleAcross = 0.0;  ///< in radians
  double aspect = 0.0;       ///< 0 if the file says nothing
};

/// Nothing if the camera's numbers cannot be. Without an aspect the picture is a square.
[[nodiscard]] std::optional<scene::View> viewOf(const ModelCamera& camera) noexcept;

}  // namespace planetree::importing
