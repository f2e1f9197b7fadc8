#include "render/image.hpp"

#include <algorithm>
#include <cmath>
#include <new>

// The whole of stb_image_write is compiled here and seen nowhere else.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace planetree::render {

namespace {

std::uint8_t quantizedChannel(float value) noexcept {
  // fmax returns the number if the other argument is NaN.
  const float clamped = std::fmin(std::fmax(value, 0.0f), 1.0f);
  return static_cast<std::uint8_t>(std::lround(clamped * 255.0f));
}

void append(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::byte>*>(context);
  const auto* first = static_cast<const std::byte*>(data);
  bytes.assign(first, first + size);
}

}  // namespace

Rgb8 quantized(const Vec3f& colour) noexcept {
  return {quantizedChannel(colour.x), quantizedChannel(colour.y), quantizedChannel(colour.z)};
}

float srgbEncoded(float linear) noexcept {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

std::vector<std::byte> encodePng(const Image& image) {
  std::vector<std::byte> bytes;
  const auto width = static_cast<int>(image.size.width);
  const auto height = static_cast<int>(image.size.height);
  const int isWritten =
      stbi_write_png_to_func(&append, &bytes, width, height, 3, image.pixels.data(), 3 * width);
  // The encoder fails for no other reason.
  if (isWritten == 0)
    throw std::bad_alloc();
  return bytes;
}

}  // namespace planetree::render
