#include "support/read_png.hpp"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <fstream>
#include <iterator>

namespace planetree::test {

namespace {

void takeBytes(png_structp png, png_bytep data, png_size_t size) {
  auto& rest = *static_cast<std::span<const std::byte>*>(png_get_io_ptr(png));
  if (size > rest.size())
    png_error(png, "the file ends early");
  std::memcpy(data, rest.data(), size);
  rest = rest.subspan(size);
}

void beSilent(png_structp /*png*/, png_const_charp /*message*/) {}

[[noreturn]] void jumpBack(png_structp png, png_const_charp /*message*/) {
  png_longjmp(png, 1);
}

/// Whether libpng could read it all; it may jump back into this function, which therefore holds
/// nothing that wants to be destroyed.
bool readAll(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png)) != 0)  // NOLINT: how libpng reports errors
    return false;
  png_read_png(png, info, PNG_TRANSFORM_STRIP_ALPHA, nullptr);
  return true;
}

PngFile contents(png_structp png, png_infop info) {
  PngFile file{
      .image = render::Image({png_get_image_width(png, info), png_get_image_height(png, info)}),
      .texts = {},
      .isSrgb = png_get_valid(png, info, PNG_INFO_sRGB) != 0};
  png_bytepp rows = png_get_rows(png, info);
  for (std::uint32_t y = 0; y < file.image.size.height; ++y) {
    std::memcpy(&file.image.at(0, y), rows[y], 3 * std::size_t{file.image.size.width});
  }
  png_textp texts = nullptr;
  const int count = png_get_text(png, info, &texts, nullptr);
  for (int i = 0; i < count; ++i)
    file.texts[texts[i].key] = texts[i].text;
  return file;
}

}  // namespace

std::optional<PngFile> readPng(std::span<const std::byte> bytes) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, &jumpBack, &beSilent);
  png_infop info = png_create_info_struct(png);
  png_set_read_fn(png, &bytes, &takeBytes);
  std::optional<PngFile> file;
  if (readAll(png, info) && png_get_channels(png, info) == 3 && png_get_bit_depth(png, info) == 8)
    file = contents(png, info);
  png_destroy_read_struct(&png, &info, nullptr);
  return file;
}

std::optional<PngFile> readPng(const std::string& bytes) {
  return readPng(std::as_bytes(std::span(bytes)));
}

std::optional<PngFile> readPng(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return readPng(std::string{std::istreambuf_iterator<char>(file), {}});
}

}  // namespace planetree::test
