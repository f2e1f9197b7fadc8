#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

/// What is needed of Sean Barrett's stb_image, behind a wall. It is written for files that can be
/// trusted: here its memory is limited, and its assertions are answers instead of ends.
namespace planetree::scene::detail {

struct ImageSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

struct DecodedImage {
  /// Red, green and blue of each texel, row by row from the top; none if it failed.
  std::unique_ptr<std::uint8_t[]> texels;
  /// Why there are none.
  std::string reason;
};

/// The size that the head of an image tells; nothing if it is the head of no PNG, JPEG, BMP or TGA.
/// `bytes` must be fewer than 2^31, here and below.
[[nodiscard]] std::optional<ImageSize> readImageSize(std::span<const std::byte> bytes);

/// The texels of an image of that size. The memory it takes grows with the size and that of the
/// file, whatever the file says. Any thread may call it at any time.
[[nodiscard]] DecodedImage decodeImage(std::span<const std::byte> bytes, const ImageSize& size);

}  // namespace planetree::scene::detail
