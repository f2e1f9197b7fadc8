#pragma once

#include <planetree/geometry/vec3.hpp>

namespace planetree::detail {

/// `triangleNormal` for floats, where it is called once for each hit. The difference of two floats
/// is exact in double, or nearly so, and far from the ends of its range.
[[nodiscard]] inline Vec3f floatNormal(const Vec3f& a, const Vec3f& b, const Vec3f& c,
                                       const Vec3f& rayDirection) noexcept {
  const auto corner = static_cast<Vec3d>(a);
  const Vec3d normal = cross(static_cast<Vec3d>(b) - corner, static_cast<Vec3d>(c) - corner);
  if (normal == Vec3d{})
    return static_cast<Vec3f>(normalized(-static_cast<Vec3d>(rayDirection)));
  return static_cast<Vec3f>(normal * (1.0 / length(normal)));
}

}  // namespace planetree::detail
