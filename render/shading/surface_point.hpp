#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace planetree::render {

/// Whether there is a hit at all: of many rays those that miss have a default-made one.
[[nodiscard]] inline bool isSurface(const Hitf& hit) noexcept {
  return hit.geometry != kNoId;
}

/// The normal of a hit on the side from which the ray came.
[[nodiscard]] inline Vec3f normalTowardViewer(const Hitf& hit, const Rayf& ray) noexcept {
  return dot(hit.normal, ray.direction) > 0.0f ? -hit.normal : hit.normal;
}

/// The length of the diagonal of a box; 0 for an empty one.
[[nodiscard]] inline float diagonal(const Box3& box) noexcept {
  return box.isEmpty() ? 0.0f : static_cast<float>(length(Vec3d(box.upper) - Vec3d(box.lower)));
}

/// How far the origins of secondary rays are moved off a surface.
///
/// A hit point is rounded to float, so it lies on either side of its surface, and a ray that starts
/// there may hit the surface itself: the picture would be peppered with dark dots. The first bound
/// is far above the rounding in a scene around the origin and far below what a picture can show.
/// The second holds for scenes far away from the origin, where the rounding outgrows the first: the
/// sum `origin + t * direction` is off by a few units in the last place of its largest term.
[[nodiscard]] inline float surfaceOffset(const Box3& scene, const Vec3f& point) noexcept {
  constexpr float kPartOfDiagonal = 2e-5f;
  constexpr float kRoundings = 8.0f;
  const float largest = std::max({std::fabs(point.x), std::fabs(point.y), std::fabs(point.z)});
  return std::max(kPartOfDiagonal * diagonal(scene),
                  kRoundings * std::numeric_limits<float>::epsilon() * largest);
}

}  // namespace planetree::render
