#pragma once

#include <planetree/geometry/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace planetree::scene {

/// How an image goes on where it ends.
enum class TextureEdges : std::uint8_t {
  Repeated,  ///< from the start, in both directions
  Wrapped,   ///< around something: from the start across, and as it ends above and below
  Clamped,   ///< as it ends: the colour of the outermost texels
};

/// An image that colours a surface: red, green, blue in [0, 1], row by row from the top.
class Texture {
 public:
  Texture(std::uint32_t width, std::uint32_t height, std::vector<Vec3f> texels)
      : width_(width), height_(height), texels_(std::move(texels)) {}

  [[nodiscard]] std::uint32_t width() const noexcept { return width_; }
  [[nodiscard]] std::uint32_t height() const noexcept { return height_; }
  /// x from the left, y from the top.
  [[nodiscard]] const Vec3f& texel(std::uint32_t x, std::uint32_t y) const noexcept {
    return texels_[static_cast<std::size_t>(y) * width_ + x];
  }

  /// Bilinear between the middles of the texels, u from the left and v from the bottom. What is not
  /// finite is taken for 0.
  [[nodiscard]] Vec3d at(double u, double v, TextureEdges edges) const noexcept;

 private:
  std::uint32_t width_;
  std::uint32_t height_;
  std::vector<Vec3f> texels_;
};

/// Reads PNG, BMP, JPEG and TGA, by stb_image; what is transparent in them is not. Throws `Error`:
/// `FileNotReadable`, `UnknownFormat`, `MalformedFile`, or `CapacityExceeded` for images of more
/// than 2^27 texels.
[[nodiscard]] Texture readTexture(const std::filesystem::path& path);
/// The same for the bytes of such a file; `name` is for errors.
[[nodiscard]] Texture readTexture(std::span<const std::byte> bytes, const std::string& name);

}  // namespace planetree::scene
