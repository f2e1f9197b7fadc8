#pragma once

#include "scene/scene_description.hpp"

#include <planetree/geometry/box3.hpp>

namespace planetree::scene {

/// A box that holds all shapes at their places: of meshes the tightest, of others one around the
/// placed box of the shape. Vertices that are not finite do not count. Empty without shapes.
[[nodiscard]] Box3 boundsOf(const SceneDescription& scene);

}  // namespace planetree::scene
