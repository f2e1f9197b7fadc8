#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace planetree::detail {

/// The number that stands at `from`, which needs no alignment, in the byte order of the file.
template <class Number>
[[nodiscard]] Number loadNumber(const std::byte* from, std::endian order) noexcept {
  std::array<std::byte, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), from, sizeof(Number));
  if (order != std::endian::native)
    std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

}  // namespace planetree::detail
