#pragma once

#include <planetree/geometry/vec3.hpp>

namespace planetree::render {

/// What a pixel sends to the eye, in linear light. The colour is that of the part of the pixel that
/// is covered, already multiplied by that part, `alpha`.
struct Light {
  Vec3f colour;
  float alpha = 0.0f;
};

/// What is seen of `behind` through `front` (Porter and Duff, "Compositing digital images",
/// SIGGRAPH 1984).
[[nodiscard]] constexpr Light over(const Light& front, const Light& behind) noexcept {
  const float through = 1.0f - front.alpha;
  return {front.colour + behind.colour * through, front.alpha + behind.alpha * through};
}

}  // namespace planetree::render
