#include "render/image.hpp"

#include <cmath>

namespace planetree::render {

namespace {

std::uint8_t quantizedChannel(float value) noexcept {
  // fmax returns the number if the other argument is NaN.
  const float clamped = std::fmin(std::fmax(value, 0.0f), 1.0f);
  return static_cast<std::uint8_t>(std::lround(clamped * 255.0f));
}

}  // namespace

Rgb8 quantized(const Vec3f& colour) noexcept {
  return {quantizedChannel(colour.x), quantizedChannel(colour.y), quantizedChannel(colour.z)};
}

float srgbEncoded(float linear) noexcept {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

Vec3f srgbEncoded(const Vec3f& linear) noexcept {
  return {srgbEncoded(linear.x), srgbEncoded(linear.y), srgbEncoded(linear.z)};
}

float srgbDecoded(float encoded) noexcept {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

Vec3f srgbDecoded(const Vec3f& encoded) noexcept {
  return {srgbDecoded(encoded.x), srgbDecoded(encoded.y), srgbDecoded(encoded.z)};
}

}  // namespace planetree::render
