#pragma once

#include "scene/scene_description.hpp"

namespace planetree::importing {

/// Makes one vertex of those that are equal, bit for bit, in all that they carry. Many readers make
/// new ones for each polygon. The first of equals stays where it is in the order; faces keep
/// theirs.
void weldCorners(scene::MeshShape& mesh);

}  // namespace planetree::importing
