#pragma once

#include "render/image.hpp"

#include <planetree/geometry/vec3.hpp>

#include <cmath>
#include <cstdint>

namespace planetree::render {

/// The light grey behind the model, in linear light: brightest above the middle of the picture,
/// fading softly toward the lower corners.
[[nodiscard]] inline Vec3f backdrop(const ImageSize& size, std::uint32_t x,
                                    std::uint32_t y) noexcept {
  const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size.width) - 0.5f;
  const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(size.height) - 0.35f;
  const float fade = std::fmin(1.0f, u * u + 1.1f * v * v);
  const Vec3f middle{0.94f, 0.95f, 0.96f};
  const Vec3f rim{0.42f, 0.46f, 0.52f};
  return middle * (1.0f - fade) + rim * fade;
}

}  // namespace planetree::render
