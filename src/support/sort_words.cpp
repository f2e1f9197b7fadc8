#include "support/sort_words.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace planetree::detail {
namespace {

using Word = std::uint64_t;

// Rows of this length are begun with.
constexpr std::size_t kShortRow = 8;
// From here on counting digits is quicker than merging.
constexpr std::size_t kLongRow = 512;

constexpr unsigned kDigitBits = 11;
constexpr std::size_t kDigitCount = std::size_t{1} << kDigitBits;
constexpr std::array<unsigned, 3> kDigitShifts = {32, 32 + kDigitBits, 32 + 2 * kDigitBits};

std::size_t digitOf(Word word, unsigned shift) noexcept {
  return static_cast<std::size_t>(word >> shift) & (kDigitCount - 1);
}

// Choices are arithmetic here, since compilers make branches of others.
Word choose(Word second, Word a, Word b) noexcept {
  return a ^ ((a ^ b) & (Word{0} - second));
}

/// The lower of the two to the first place.
void order(Word& a, Word& b) noexcept {
  const Word swapped = (a ^ b) & (Word{0} - Word{b < a});
  a ^= swapped;
  b ^= swapped;
}

/// Sorts eight words. Batcher, "Sorting networks and their applications", 1968.
void sortEight(Word* w) noexcept {
  for (const std::size_t i : {0u, 2u, 4u, 6u})
    order(w[i], w[i + 1]);
  for (const std::size_t i : {0u, 1u, 4u, 5u})
    order(w[i], w[i + 2]);
  order(w[1], w[2]);
  order(w[5], w[6]);
  for (const std::size_t i : {0u, 1u, 2u, 3u})
    order(w[i], w[i + 4]);
  order(w[2], w[4]);
  order(w[3], w[5]);
  for (const std::size_t i : {1u, 3u, 5u})
    order(w[i], w[i + 1]);
}

/// Sorts at most eight words.
void sortShort(Word* words, std::size_t count) noexcept {
  std::array<Word, kShortRow> row;
  row.fill(~Word{0});
  std::copy_n(words, count, row.data());
  sortEight(row.data());
  std::copy_n(row.data(), count, words);
}

/// Merges two sorted rows that follow each other.
void merge(const Word* begin, const Word* middle, const Word* end, Word* to) noexcept {
  const Word* left = begin;
  const Word* right = middle;
  while (left != middle && right != end) {
    const Word isRight = Word{*right < *left};
    *to++ = choose(isRight, *left, *right);
    right += isRight;
    left += isRight ^ 1u;
  }
  to = std::copy(left, middle, to);
  std::copy(right, end, to);
}

/// The same for rows of equal length, from both ends at once: neither side can run out, and the
/// steps of one need not wait for those of the other. Scandum, "quadsort", 2020 ("parity merge").
void mergeEqual(const Word* begin, std::size_t length, Word* to) noexcept {
  const Word* left = begin;
  const Word* right = begin + length;
  const Word* leftEnd = begin + length - 1;
  const Word* rightEnd = begin + 2 * length - 1;
  Word* toEnd = to + 2 * length - 1;
  for (std::size_t i = 0; i < length; ++i) {
    const Word isRight = Word{*right < *left};
    to[i] = choose(isRight, *left, *right);
    right += isRight;
    left += isRight ^ 1u;
    const Word isLeftEnd = Word{*rightEnd < *leftEnd};
    *toEnd-- = choose(isLeftEnd, *rightEnd, *leftEnd);
    leftEnd -= isLeftEnd;
    rightEnd -= isLeftEnd ^ 1u;
  }
}

}  // namespace

void WordSorter::sort(std::span<Word> words) {
  if (words.size() <= kShortRow)
    return sortShort(words.data(), words.size());
  if (other_.size() < words.size())
    other_.resize(words.size());
  if (words.size() < kLongRow)
    sortByMerging(words);
  else
    sortByDigits(words);
}

void WordSorter::sortByMerging(std::span<Word> words) {
  const std::size_t count = words.size();
  const std::size_t wholeRows = count / kShortRow * kShortRow;
  for (std::size_t begin = 0; begin < wholeRows; begin += kShortRow)
    sortEight(words.data() + begin);
  sortShort(words.data() + wholeRows, count - wholeRows);
  Word* from = words.data();
  Word* to = other_.data();
  for (std::size_t length = kShortRow; length < count; length *= 2) {
    for (std::size_t begin = 0; begin < count; begin += 2 * length) {
      const std::size_t middle = std::min(begin + length, count);
      const std::size_t end = std::min(begin + 2 * length, count);
      if (end - begin == 2 * length)
        mergeEqual(from + begin, length, to + begin);
      else
        merge(from + begin, from + middle, from + end, to + begin);
    }
    std::swap(from, to);
  }
  if (from != words.data())
    std::copy_n(from, count, words.data());
}

void WordSorter::sortByDigits(std::span<Word> words) {
  std::array<std::array<std::uint32_t, kDigitCount>, kDigitShifts.size()> counts = {};
  for (const Word word : words) {
    for (std::size_t digit = 0; digit < counts.size(); ++digit)
      ++counts[digit][digitOf(word, kDigitShifts[digit])];
  }
  Word* from = words.data();
  Word* to = other_.data();
  for (std::size_t digit = 0; digit < counts.size(); ++digit) {
    std::uint32_t sum = 0;
    for (std::uint32_t& count : counts[digit])
      sum += std::exchange(count, sum);
    for (std::size_t i = 0; i < words.size(); ++i)
      to[counts[digit][digitOf(from[i], kDigitShifts[digit])]++] = from[i];
    std::swap(from, to);
  }
  std::copy_n(from, words.size(), words.data());
}

}  // namespace planetree::detail
