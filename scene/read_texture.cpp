#include "scene/texture.hpp"

#include "scene/stb_image.hpp"
#include "support/read_file.hpp"

#include <planetree/error.hpp>

#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace planetree::scene {
namespace {

constexpr std::uint64_t kMostTexels = std::uint64_t{1} << 27;

Error failed(ErrorCode code, const std::string& problem, const std::string& advice,
             const std::string& name) {
  return Error(code, problem, advice, Error::Place{.file = name});
}

bool beginsLikeImage(std::span<const std::byte> bytes) noexcept {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.starts_with("\x89PNG") || text.starts_with("\xFF\xD8\xFF") || text.starts_with("BM");
}

/// The texels that so many bytes can hold at most. Deflate makes a byte of PNG 1032 bytes, each of
/// them eight texels of black and white; JPEG has a bit for each 8 x 8 texels at least. Compressed
/// TGA stays below that, and BMP is not compressed.
std::uint64_t mostTexelsIn(std::span<const std::byte> bytes) noexcept {
  constexpr std::uint64_t kPerByteOfPng = 8 * 1032;
  constexpr std::uint64_t kPerByteOfOthers = 512;
  const bool isPng = !bytes.empty() && bytes[0] == std::byte{0x89};
  return (isPng ? kPerByteOfPng : kPerByteOfOthers) * bytes.size();
}

}  // namespace

Texture readTexture(const std::filesystem::path& path) {
  planetree::detail::refuseDeviceOrPipe(path, "Name an image file");
  const planetree::detail::FileContent content = planetree::detail::readFile(path);
  return readTexture(content.bytes(), path.string());
}

Texture readTexture(std::span<const std::byte> bytes, const std::string& name) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw failed(ErrorCode::CapacityExceeded, "the image file has more than 2147483647 bytes",
                 "Make it smaller", name);
  }
  const std::optional<detail::ImageSize> size = detail::readImageSize(bytes);
  if (!size && !beginsLikeImage(bytes)) {
    throw failed(ErrorCode::UnknownFormat, "it is no PNG, JPEG, BMP or TGA image",
                 "Convert it to PNG", name);
  }
  if (!size) {
    throw failed(ErrorCode::MalformedFile, "the head of the image is damaged or of a rare kind",
                 "Save it again as PNG", name);
  }
  if (std::uint64_t{size->width} * size->height > kMostTexels) {
    throw failed(ErrorCode::CapacityExceeded,
                 "the image is too large, " + std::to_string(size->width) + " x " +
                     std::to_string(size->height) + " texels",
                 "Make it smaller: up to 134217728 texels are read", name);
  }
  // stb_image takes what is missing at the end of some files for black.
  if (std::uint64_t{size->width} * size->height > mostTexelsIn(bytes)) {
    throw failed(ErrorCode::MalformedFile,
                 "the image is to have " + std::to_string(size->width) + " x " +
                     std::to_string(size->height) + " texels, but too few bytes for that",
                 "The file is truncated or damaged: copy or save it again", name);
  }
  const detail::DecodedImage image = detail::decodeImage(bytes, *size);
  if (!image.texels) {
    throw failed(ErrorCode::MalformedFile, "the image cannot be decoded (" + image.reason + ")",
                 "Save it again as PNG", name);
  }
  std::vector<Vec3f> texels(std::size_t{size->width} * size->height);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const std::uint8_t* const rgb = image.texels.get() + 3 * i;
    texels[i] =
        Vec3f{static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])} /
        255.0f;
  }
  return {size->width, size->height, std::move(texels)};
}

}  // namespace planetree::scene
