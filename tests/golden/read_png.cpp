#include "read_png.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

// The whole of stb_image is compiled here and seen nowhere else.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace planetree::test {

std::optional<render::Image> readPng(std::span<const std::byte> bytes) {
  constexpr int kChannels = 3;
  int width = 0;
  int height = 0;
  int channelsInFile = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                            static_cast<int>(bytes.size()), &width, &height, &channelsInFile,
                            kChannels),
      &stbi_image_free);
  if (!pixels)
    return std::nullopt;
  render::Image image({static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)});
  std::memcpy(image.pixels.data(), pixels.get(), image.pixels.size() * kChannels);
  return image;
}

std::optional<render::Image> readPng(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  return readPng(std::as_bytes(std::span(bytes)));
}

}  // namespace planetree::test
