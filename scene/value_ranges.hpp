#pragma once

#include <planetree/geometry/vec3.hpp>

/// What values of a scene mean something, whichever file says them: the readers refuse the others.
/// NaN is never among them.
namespace planetree::scene {

/// Of parts of a colour, of coefficients of attenuation, and of the exponent of a highlight.
[[nodiscard]] constexpr bool isAmount(double value) noexcept {
  return value >= 0.0;
}

/// Of an index of refraction, and of sizes.
[[nodiscard]] constexpr bool isPositive(double value) noexcept {
  return value > 0.0;
}

}  // namespace planetree::scene
