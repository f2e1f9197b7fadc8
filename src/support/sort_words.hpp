#pragma once

#include "support/plain_array.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace planetree::detail {

/// An unsigned number whose order is that of the floats, for all but NaN; -0 and +0 are equal.
[[nodiscard]] inline std::uint32_t orderedBits(float value) noexcept {
  const auto bits = std::bit_cast<std::uint32_t>(value + 0.0f);
  return (bits >> 31u) != 0 ? ~bits : bits | 0x8000'0000u;
}
[[nodiscard]] inline float fromOrderedBits(std::uint32_t bits) noexcept {
  return std::bit_cast<float>((bits >> 31u) != 0 ? bits & 0x7FFF'FFFFu : ~bits);
}

/// Sorts many short rows of words one after the other, with room that is used again. Without a
/// branch that depends on the words: half of them would be guessed wrong, which costs more than all
/// the rest. Of long rows only the upper 32 bits are looked at, and words that are equal there keep
/// their order; so all do whose lower half rises.
class WordSorter {
 public:
  void sort(std::span<std::uint64_t> words);

 private:
  void sortByMerging(std::span<std::uint64_t> words);
  void sortByDigits(std::span<std::uint64_t> words);

  PlainArray<std::uint64_t> other_;
};

}  // namespace planetree::detail
