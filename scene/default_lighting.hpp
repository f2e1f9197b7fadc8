#pragma once

#include "scene/scene_description.hpp"

namespace planetree::scene {

/// Lights a scene that has no lights at all, and returns whether it did: a key light from the upper
/// left of the viewer, a fill light from the right that leaves its shadows readable, and some
/// ambient light. Neither light gets weaker with distance. Together they make a white surface white
/// at most.
///
/// The viewer is the scene's view. Without one it is as `planetree render` looks at a model: a
/// little from the right and from above, with y up. If the viewer is inside the box around the
/// scene, as in a room, the walls would keep light from outside away: then the key light is a
/// little beside the eye, and the fill light in the middle of the scene.
bool addDefaultLighting(SceneDescription& scene);

}  // namespace planetree::scene
