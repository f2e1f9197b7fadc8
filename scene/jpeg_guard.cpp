#include "scene/jpeg_guard.hpp"

#include <algorithm>
#include <cstdint>

// ITU-T recommendation T.81, "Digital compression and coding of continuous-tone still images",
// 1992, annex B.
namespace planetree::scene::detail {
namespace {

constexpr std::byte kMarker{0xFF};
constexpr std::byte kDefineHuffmanTables{0xC4};
constexpr std::byte kStartOfImage{0xD8};
constexpr std::byte kEndOfImage{0xD9};
constexpr std::byte kStartOfScan{0xDA};

/// 0 behind the end, as stb_image has it.
std::uint32_t byteAt(std::span<const std::byte> bytes, std::size_t offset) noexcept {
  return offset < bytes.size() ? std::to_integer<std::uint32_t>(bytes[offset]) : 0;
}

/// Comments, and what programs add; but not the heads of JFIF and Adobe, which colours depend on.
bool isDispensable(std::uint32_t marker) noexcept {
  return marker == 0xFE || (marker >= 0xE1 && marker <= 0xEF && marker != 0xEE);
}

/// Goes through a definition as stb_image does: tables one after the other, whatever comes.
bool hasPossibleTables(std::span<const std::byte> bytes, std::size_t offset) noexcept {
  constexpr std::uint32_t kMostCodes = 256;
  constexpr std::size_t kLengthCount = 16;
  auto rest = static_cast<std::int64_t>(byteAt(bytes, offset) << 8 | byteAt(bytes, offset + 1)) - 2;
  offset += 2;
  while (rest > 0) {
    std::uint32_t codeCount = 0;
    for (std::size_t i = 0; i < kLengthCount; ++i)
      codeCount += byteAt(bytes, offset + 1 + i);
    if (codeCount > kMostCodes)
      return false;
    offset += 1 + kLengthCount + codeCount;
    rest -= static_cast<std::int64_t>(1 + kLengthCount + codeCount);
  }
  return true;
}

/// Copies all up to the first scan, but for what is dispensable, and returns where that scan is, or
/// what is no segment.
std::size_t copyHead(std::span<const std::byte> bytes, std::vector<std::byte>& copy) {
  std::size_t offset = 2;
  copy.insert(copy.end(), bytes.begin(), bytes.begin() + 2);
  while (offset + 4 <= bytes.size() && bytes[offset] == kMarker) {
    const std::uint32_t marker = byteAt(bytes, offset + 1);
    if (marker == 0xFF) {  // a marker may begin with several
      ++offset;
      continue;
    }
    const std::size_t size = 2 + (byteAt(bytes, offset + 2) << 8 | byteAt(bytes, offset + 3));
    if (bytes[offset + 1] == kStartOfScan || size < 4 || size > bytes.size() - offset)
      break;
    const auto segment = bytes.subspan(offset, size);
    if (!isDispensable(marker))
      copy.insert(copy.end(), segment.begin(), segment.end());
    offset += size;
  }
  return offset;
}

}  // namespace

bool isJpeg(std::span<const std::byte> bytes) noexcept {
  return bytes.size() > 2 && bytes[0] == kMarker;
}

std::optional<std::vector<std::byte>> guardedJpeg(std::span<const std::byte> bytes) {
  if (bytes.size() < 4 || bytes[1] != kStartOfImage)
    return std::nullopt;
  std::vector<std::byte> copy;
  copy.reserve(bytes.size());
  const auto rest = bytes.subspan(copyHead(bytes, copy));
  // What follows the image, such as a second one, does not belong to it.
  constexpr std::byte kEnd[] = {kMarker, kEndOfImage};
  const auto end = std::search(rest.begin(), rest.end(), std::begin(kEnd), std::end(kEnd));
  copy.insert(copy.end(), rest.begin(), end);
  copy.insert(copy.end(), std::begin(kEnd), std::end(kEnd));

  for (std::size_t i = 0; i + 1 < copy.size(); ++i) {
    if (copy[i] == kMarker && copy[i + 1] == kDefineHuffmanTables &&
        !hasPossibleTables(copy, i + 2))
      return std::nullopt;
  }
  return copy;
}

}  // namespace planetree::scene::detail
