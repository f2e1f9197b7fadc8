#include "render/file/encode_png.hpp"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <new>
#include <string>

namespace planetree::render {

namespace {

bool isAscii(const std::string& text) noexcept {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::vector<png_text> textChunks(const Metadata& metadata) {
  std::vector<png_text> chunks;
  for (const MetadataEntry& entry : metadata) {
    png_text chunk{};
    chunk.compression = isAscii(entry.text) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    // libpng copies both and changes neither.
    chunk.key = const_cast<char*>(entry.key.c_str());
    chunk.text = const_cast<char*>(entry.text.c_str());
    chunks.push_back(chunk);
  }
  return chunks;
}

void append(png_structp png, png_bytep data, png_size_t size) {
  auto& bytes = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
  bool isAppended = true;
  try {
    const auto* first = reinterpret_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), first, first + size);
  } catch (...) {
    isAppended = false;
  }
  // Exceptions must not pass through libpng, and it must not jump out of a handler.
  if (!isAppended)
    png_error(png, "out of memory");
}

void beSilent(png_structp /*png*/, png_const_charp /*message*/) {}

[[noreturn]] void jumpBack(png_structp png, png_const_charp /*message*/) {
  png_longjmp(png, 1);
}

/// Everything to be written, found before: the function that libpng may jump back into must not
/// hold anything that wants to be destroyed.
struct PngContents {
  const Image& image;
  std::vector<png_text> texts;
};

/// Whether libpng could write it all.
bool write(png_structp png, png_infop info, const PngContents& contents) {
  if (setjmp(png_jmpbuf(png)) != 0)  // NOLINT: how libpng reports errors
    return false;
  const ImageSize& size = contents.image.size;
  // Otherwise libpng stops at a million pixels a side.
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  constexpr int kBitsPerChannel = 8;
  png_set_IHDR(png, info, size.width, size.height, kBitsPerChannel, PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_text(png, info, contents.texts.data(), static_cast<int>(contents.texts.size()));
  png_write_info(png, info);
  for (std::size_t y = 0; y < size.height; ++y) {
    png_write_row(png,
                  reinterpret_cast<png_const_bytep>(contents.image.pixels.data() + y * size.width));
  }
  png_write_end(png, nullptr);
  return true;
}

}  // namespace

std::vector<std::byte> encodePng(const Image& image, const Metadata& metadata) {
  std::vector<std::byte> bytes;
  const PngContents contents{image, textChunks(metadata)};
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, &jumpBack, &beSilent);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  bool isWritten = false;
  if (info != nullptr) {
    png_set_write_fn(png, &bytes, &append, nullptr);
    isWritten = write(png, info, contents);
  }
  png_destroy_write_struct(&png, &info);
  // With sizes and names as their types promise, writing fails for no other reason.
  if (!isWritten)
    throw std::bad_alloc();
  return bytes;
}

}  // namespace planetree::render
