#pragma once

#include "render/camera.hpp"

#include <planetree/geometry/vec3.hpp>

#include <span>
#include <string>

namespace planetree::bench {

/// Where the primary rays of a scene come from: a place inside, for the interiors known by the name
/// of their file; for everything else a view that frames the model from outside.
///
/// Benchmarks of different years are compared by these rays: an entry is never changed.
[[nodiscard]] render::Camera sceneCamera(const std::string& scene,
                                         std::span<const Vec3f> positions);

/// A square picture of the model from a little right and above: as near as possible with the box
/// from the 2nd to the 98th percentile of the positions inside it. Positions that are not finite do
/// not count; without any finite one it is a default-made camera.
[[nodiscard]] render::Camera framingCamera(std::span<const Vec3f> positions);

}  // namespace planetree::bench
