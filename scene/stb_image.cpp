#include "scene/stb_image.hpp"

#include "scene/jpeg_guard.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <vector>

namespace planetree::scene::detail {
namespace {

/// The memory of one call into stb_image. What it has not freed, for an assertion stopped it, is
/// freed with this. There are never more than some dozens of blocks.
class DecoderMemory {
 public:
  explicit DecoderMemory(std::size_t limit) noexcept : limit_(limit) { current = this; }
  DecoderMemory(const DecoderMemory&) = delete;
  DecoderMemory& operator=(const DecoderMemory&) = delete;
  ~DecoderMemory() {
    current = nullptr;
    for (const Block& block : blocks_)
      std::free(block.start);
  }

  /// Zeros: stb_image does not notice when some files end early, and a picture must not depend on
  /// what was in the memory before.
  void* allocate(std::size_t size) noexcept {
    if (size > limit_ - used_)
      return nullptr;
    void* const start = std::calloc(std::max<std::size_t>(size, 1), 1);
    if (start == nullptr)
      return nullptr;
    try {
      blocks_.push_back({start, size});
    } catch (const std::bad_alloc&) {
      std::free(start);
      return nullptr;
    }
    used_ += size;
    return start;
  }

  void* reallocate(void* old, std::size_t oldSize, std::size_t newSize) noexcept {
    void* const start = allocate(newSize);
    if (start != nullptr && old != nullptr) {
      std::memcpy(start, old, std::min(oldSize, newSize));
      free(old);
    }
    return start;
  }

  void free(void* start) noexcept {
    const auto block = std::find_if(blocks_.begin(), blocks_.end(),
                                    [&](const Block& b) { return b.start == start; });
    if (block == blocks_.end())
      return;
    used_ -= block->size;
    std::free(start);
    blocks_.erase(block);
  }

  /// That of the call this thread is in.
  static thread_local DecoderMemory* current;

 private:
  struct Block {
    void* start;
    std::size_t size;
  };

  std::vector<Block> blocks_;
  std::size_t limit_;
  std::size_t used_ = 0;
};

thread_local DecoderMemory* DecoderMemory::current = nullptr;

void requireInDecoder(bool holds) {
  if (!holds)
    throw std::logic_error("an assertion of stb_image failed");
}

}  // namespace
}  // namespace planetree::scene::detail

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_NO_LINEAR
#define STBI_ASSERT(x) planetree::scene::detail::requireInDecoder(static_cast<bool>(x))
#define STBI_MALLOC(size) planetree::scene::detail::DecoderMemory::current->allocate(size)
#define STBI_REALLOC_SIZED(old, oldSize, newSize) \
  planetree::scene::detail::DecoderMemory::current->reallocate(old, oldSize, newSize)
#define STBI_FREE(start) planetree::scene::detail::DecoderMemory::current->free(start)
// What it expands of the macros above counts as ours.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#ifndef __clang__
// g++ does not see that `buflen` goes with `read`, which is null here.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace planetree::scene::detail {
namespace {

constexpr std::size_t kOverhead = std::size_t{1} << 20;

/// The largest amounts that decoding takes at once: the texels in several forms of up to eight
/// bytes, in blocks of up to 32 x 32, and the bytes of the file put together, in an array that
/// grows by doubling.
std::size_t memoryLimit(std::size_t fileSize, const ImageSize& size) noexcept {
  constexpr std::size_t kBlock = 32;
  constexpr std::size_t kBytesForTexel = 32;
  return kOverhead + 8 * fileSize + kBytesForTexel * (size.width + kBlock) * (size.height + kBlock);
}

/// A file that stb_image can be shown: itself, or if it is a JPEG one, its guarded copy.
class SafeBytes {
 public:
  explicit SafeBytes(std::span<const std::byte> bytes) : bytes_(bytes) {
    if (!isJpeg(bytes))
      return;
    copy_ = guardedJpeg(bytes);
    isSafe_ = copy_.has_value();
    if (isSafe_)
      bytes_ = *copy_;
  }
  SafeBytes(const SafeBytes&) = delete;
  SafeBytes& operator=(const SafeBytes&) = delete;

  [[nodiscard]] bool isSafe() const noexcept { return isSafe_; }
  [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return bytes_; }

 private:
  std::optional<std::vector<std::byte>> copy_;
  std::span<const std::byte> bytes_;
  bool isSafe_ = true;
};

const stbi_uc* bytesOf(std::span<const std::byte> bytes) noexcept {
  return reinterpret_cast<const stbi_uc*>(bytes.data());
}

std::string failureReason() {
  const char* const reason = stbi_failure_reason();
  return reason == nullptr ? "it is damaged" : reason;
}

}  // namespace

std::optional<ImageSize> readImageSize(std::span<const std::byte> bytes) {
  const SafeBytes safe(bytes);
  if (!safe.isSafe())
    return std::nullopt;
  DecoderMemory memory(kOverhead);
  int width = 0;
  int height = 0;
  int channels = 0;
  try {
    if (!stbi_info_from_memory(bytesOf(safe.bytes()), static_cast<int>(safe.bytes().size()), &width,
                               &height, &channels))
      return std::nullopt;
  } catch (const std::logic_error&) {
    return std::nullopt;
  }
  if (width <= 0 || height <= 0)
    return std::nullopt;
  return ImageSize{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

DecodedImage decodeImage(std::span<const std::byte> bytes, const ImageSize& size) {
  constexpr int kChannels = 3;
  const SafeBytes safe(bytes);
  if (!safe.isSafe())
    return {nullptr, "it is a damaged JPEG file"};
  DecoderMemory memory(memoryLimit(bytes.size(), size));
  int width = 0;
  int height = 0;
  int channels = 0;
  const stbi_uc* texels = nullptr;
  try {
    texels = stbi_load_from_memory(bytesOf(safe.bytes()), static_cast<int>(safe.bytes().size()),
                                   &width, &height, &channels, kChannels);
  } catch (const std::logic_error& error) {
    return {nullptr, error.what()};
  }
  if (texels == nullptr)
    return {nullptr, failureReason()};
  if (static_cast<std::uint32_t>(width) != size.width ||
      static_cast<std::uint32_t>(height) != size.height)
    return {nullptr, "its size is not the one its head tells"};
  const std::size_t count = std::size_t{kChannels} * size.width * size.height;
  auto copy = std::make_unique_for_overwrite<std::uint8_t[]>(count);
  std::memcpy(copy.get(), texels, count);
  return {std::move(copy), {}};
}

}  // namespace planetree::scene::detail
