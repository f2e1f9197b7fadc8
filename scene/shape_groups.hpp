#pragma once

#include "scene/scene_description.hpp"

#include <planetree/scene.hpp>

#include <cstdint>
#include <vector>

namespace planetree::scene {

/// The shapes of one geometry of a tree: many of one kind, or one mesh.
struct ShapeGroup {
  std::vector<std::uint32_t> shapes;     ///< indices in `SceneDescription::shapes`
  std::uint32_t primitivesPerShape = 1;  ///< 0 is all of them: there is one shape

  [[nodiscard]] std::uint32_t shapeOf(std::uint32_t primitive) const noexcept {
    return shapes[primitivesPerShape == 0 ? 0 : primitive / primitivesPerShape];
  }
};

/// All shapes of a scene at their places, as a tree takes them.
struct GroupedShapes {
  Scene<float> scene;
  std::vector<ShapeGroup> groups;  ///< one for each geometry of `scene`
};

/// Throws `Error` with `InvalidGeometry` if a placement is singular.
[[nodiscard]] GroupedShapes groupShapes(const SceneDescription& description);

/// A place on a side of the unit box, both from 0 to 1: upright and unmirrored as seen from
/// outside, with y up (on the top and the bottom, -z and z).
struct BoxPlace {
  double u = 0.0;
  double v = 0.0;
};

/// Where a point is on the side that a triangle of a box belongs to; `primitive` is that of the
/// hit. The side is not taken from the point: on a thin box the rounding of the point decides
/// nothing.
[[nodiscard]] BoxPlace placeOnUnitBox(const Vec3d& point, std::uint32_t primitive) noexcept;

}  // namespace planetree::scene
