#pragma once

#include <planetree/geometry/vec3.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace planetree::detail {

/// True if a hit at t may be reported. NaN and infinity, as overflow leaves them, never are.
template <class T>
[[nodiscard]] bool isWithin(T t, T tMin, T tMax) noexcept {
  return std::isfinite(t) && tMin <= t && t <= tMax;
}

/// A ray whose origin was moved along it to where it is closest to the centre of a shape, with
/// coordinates relative to that centre. What is computed from it is as exact as the shape is large,
/// however far away the ray begins: the move costs about three roundings of the distance, and no
/// discriminant ever sees its square.
///
/// Haines, Guenther, Akenine-Moeller, "Precision improvements for ray/sphere intersection", Ray
/// Tracing Gems, 2019. There the closest approach serves the discriminant of a sphere alone; here
/// it serves every curved or slanted shape. The direction is scaled by a power of two, so its
/// length matters to no result.
struct CenteredRay {
  Vec3d origin;
  Vec3d direction;
  double shift = 0.0;  ///< of the origin, in units of `direction`
  double scale = 1.0;  ///< the power of two that divides the direction

  [[nodiscard]] Vec3d at(double s) const noexcept { return origin + direction * s; }

  /// The t of the original ray at the parameter `s` of this one.
  template <class T>
  [[nodiscard]] T rayParameter(double s) const noexcept {
    return static_cast<T>((shift + s) / scale);
  }
};

/// The power of two at or below x > 0; the smallest normal number if x is below that.
[[nodiscard]] inline double powerOfTwoBelow(double x) noexcept {
  constexpr std::uint64_t kExponentBits = 0x7FF0'0000'0000'0000u;
  const auto power = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & kExponentBits);
  return std::fmax(power, std::numeric_limits<double>::min());
}

/// `origin` is relative to the centre of the shape: the caller subtracts, because only he knows how
/// to do so without rounding at the size of the coordinates. Nothing for a ray that misses all.
[[nodiscard]] inline std::optional<CenteredRay> centeredRay(const Vec3d& origin,
                                                            const Vec3d& direction) noexcept {
  const double largest =
      std::fmax(std::fabs(direction.x), std::fmax(std::fabs(direction.y), std::fabs(direction.z)));
  if (!isFinite(origin) || !isFinite(direction) || largest == 0.0)
    return std::nullopt;
  CenteredRay centered;
  centered.scale = powerOfTwoBelow(largest);
  centered.direction = direction / centered.scale;
  centered.shift = -dot(origin, centered.direction) / dot(centered.direction, centered.direction);
  centered.origin = origin + centered.direction * centered.shift;
  return centered;
}

/// The angle of (x, y) from +x through +y, as a fraction in [0, 1] of the full turn.
[[nodiscard]] inline double turnFraction(double x, double y) noexcept {
  constexpr double kFullTurn = 6.283185307179586;
  // Adding zero drops the sign of a zero, which says nothing about the point.
  const double turn = std::atan2(y + 0.0, x + 0.0) / kFullTurn;
  return turn < 0.0 ? turn + 1.0 : turn;
}

}  // namespace planetree::detail
