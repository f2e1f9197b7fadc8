#pragma once

#include <planetree/geometry/vec3.hpp>

#include <cmath>
#include <optional>

namespace planetree::render {

/// The mirror image of `incoming`, which travels toward the surface. Both are of unit length if
/// `normal` is.
[[nodiscard]] inline Vec3d reflected(const Vec3d& incoming, const Vec3d& normal) noexcept {
  return incoming - normal * (2.0 * dot(incoming, normal));
}

/// The direction of light behind a surface by Snell's law, of unit length; nothing beyond the
/// critical angle, where all light is reflected. `normal` points outward, and `index` is that of
/// the inside relative to the outside: the light enters if it travels against the normal, and
/// leaves otherwise.
[[nodiscard]] inline std::optional<Vec3d> refracted(const Vec3d& incoming, const Vec3d& normal,
                                                    double index) noexcept {
  const bool enters = dot(incoming, normal) < 0.0;
  const Vec3d facing = enters ? normal : -normal;
  const double ratio = enters ? 1.0 / index : index;
  const double cosine = -dot(incoming, facing);
  const double squaredCosineBehind = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
  if (!(squaredCosineBehind >= 0.0))
    return std::nullopt;
  return normalized(incoming * ratio + facing * (ratio * cosine - std::sqrt(squaredCosineBehind)));
}

}  // namespace planetree::render
