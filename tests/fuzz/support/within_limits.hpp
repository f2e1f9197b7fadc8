#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/ray.hpp>

#include <algorithm>
#include <cmath>

/// The limits of docs/limits.md. Beyond them nothing crashes, but hits may be lost.
namespace planetree::fuzz {

[[nodiscard]] inline bool isWithinLimits(const Box3& scene) noexcept {
  if (scene.isEmpty())
    return true;
  double extent = 0.0;
  double farthest = 0.0;
  for (const Axis axis : kAxes) {
    const double lower = scene.lower[axis];
    const double upper = scene.upper[axis];
    extent = std::max(extent, upper - lower);
    farthest = std::max({farthest, std::abs(lower), std::abs(upper)});
  }
  return extent >= 0x1p-30 && extent <= 0x1p30 && farthest <= 0x1p30;
}

/// Whether the answer of a ray is the exact one. Rays that miss by definition have no limits.
template <class T>
[[nodiscard]] bool isWithinLimits(const Ray<T>& ray, const Box3& scene) noexcept {
  if (!isFinite(ray.origin) || !isFinite(ray.direction) || ray.direction == Vec3<T>{})
    return true;
  const auto largestOf = [](const Vec3<T>& vector) {
    return std::max({std::abs(static_cast<double>(vector.x)),
                     std::abs(static_cast<double>(vector.y)),
                     std::abs(static_cast<double>(vector.z))});
  };
  // Less than the limits by the length of a diagonal.
  const double reach = largestOf(ray.direction);
  return isWithinLimits(scene) && largestOf(ray.origin) <= 0x1p39 && reach >= 0x1p-60 &&
         reach <= 0x1p59;
}

}  // namespace planetree::fuzz
