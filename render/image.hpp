#pragma once

#include <planetree/geometry/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace planetree::render {

/// A width and a height in pixels.
struct ImageSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  friend constexpr bool operator==(const ImageSize&, const ImageSize&) noexcept = default;

  [[nodiscard]] constexpr std::size_t pixelCount() const noexcept {
    return static_cast<std::size_t>(width) * height;
  }
};

/// Part of a picture: its upper left corner, and how large it is.
struct PixelWindow {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  ImageSize size;

  friend constexpr bool operator==(const PixelWindow&, const PixelWindow&) noexcept = default;
};

/// A colour as a screen takes it (sRGB), eight bits a channel.
struct Rgb8 {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend constexpr bool operator==(const Rgb8&, const Rgb8&) noexcept = default;
};
static_assert(sizeof(Rgb8) == 3);

/// Channels in [0, 1], as a screen takes them, rounded to the nearest of the 256 steps. Values
/// outside are clamped; NaN gives 0.
[[nodiscard]] Rgb8 quantized(const Vec3f& colour) noexcept;

/// The sRGB encoding of a channel that is proportional to light (IEC 61966-2-1).
[[nodiscard]] float srgbEncoded(float linear) noexcept;
[[nodiscard]] Vec3f srgbEncoded(const Vec3f& linear) noexcept;
/// Its inverse.
[[nodiscard]] float srgbDecoded(float encoded) noexcept;
[[nodiscard]] Vec3f srgbDecoded(const Vec3f& encoded) noexcept;

/// A picture, row by row from the top left.
struct Image {
  ImageSize size;
  std::vector<Rgb8> pixels;

  explicit Image(ImageSize imageSize) : size(imageSize), pixels(imageSize.pixelCount()) {}

  [[nodiscard]] Rgb8& at(std::uint32_t x, std::uint32_t y) noexcept { return pixels[index(x, y)]; }
  [[nodiscard]] const Rgb8& at(std::uint32_t x, std::uint32_t y) const noexcept {
    return pixels[index(x, y)];
  }

 private:
  [[nodiscard]] std::size_t index(std::uint32_t x, std::uint32_t y) const noexcept {
    return static_cast<std::size_t>(y) * size.width + x;
  }
};

}  // namespace planetree::render
