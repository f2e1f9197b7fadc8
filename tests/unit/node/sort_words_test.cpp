#include "support/sort_words.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace planetree::detail {
namespace {

using test::describeSeed;
using test::Random;
using Words = std::vector<std::uint64_t>;

std::uint32_t upperHalf(std::uint64_t word) {
  return static_cast<std::uint32_t>(word >> 32u);
}

Words stablySorted(Words words) {
  std::ranges::stable_sort(words, std::less{}, upperHalf);
  return words;
}

Words sorted(WordSorter& sorter, Words words) {
  sorter.sort(words);
  return words;
}

/// Words whose upper halves `makeUpper` makes, and whose lower halves rise.
Words wordsWith(std::size_t count, const std::function<std::uint32_t(std::size_t)>& makeUpper) {
  Words words(count);
  for (std::size_t i = 0; i < count; ++i)
    words[i] = std::uint64_t{makeUpper(i)} << 32u | i;
  return words;
}

/// All lengths that take a way of their own, and those around them.
std::vector<std::size_t> lengths() {
  std::vector<std::size_t> lengths;
  for (std::size_t length = 0; length <= 600; ++length)
    lengths.push_back(length);
  for (const std::size_t length : {1000u, 1024u, 2000u})
    lengths.insert(lengths.end(), {length - 1, length, length + 1});
  return lengths;
}

TEST(WordSorter, SortsAsAStableSortByTheUpperHalf) {
  SCOPED_TRACE(describeSeed());
  Random random(81);
  WordSorter sorter;
  constexpr std::uint32_t kAll = std::numeric_limits<std::uint32_t>::max();
  const std::vector<std::pair<std::string, std::function<std::uint32_t(std::size_t)>>> rows = {
      {"any", [&](std::size_t) { return static_cast<std::uint32_t>(random.below(kAll)); }},
      {"few", [&](std::size_t) { return static_cast<std::uint32_t>(random.below(5)); }},
      {"high bits alone",
       [&](std::size_t) { return static_cast<std::uint32_t>(random.below(8) << 29u); }},
      {"all equal", [](std::size_t) { return 7u; }},
      {"the largest", [](std::size_t) { return kAll; }},
      {"rising", [](std::size_t i) { return static_cast<std::uint32_t>(i); }},
      {"falling", [](std::size_t i) { return kAll - static_cast<std::uint32_t>(i); }},
      {"two rising rows", [](std::size_t i) { return static_cast<std::uint32_t>(i % 64); }},
  };
  for (const std::size_t length : lengths()) {
    for (const auto& [name, makeUpper] : rows) {
      const Words words = wordsWith(length, makeUpper);
      ASSERT_EQ(sorted(sorter, words), stablySorted(words)) << length << " words: " << name;
    }
  }
}

TEST(WordSorter, KeepsTheLargestWord) {
  WordSorter sorter;
  for (const std::size_t length : {std::size_t{3}, std::size_t{9}, std::size_t{700}}) {
    Words words(length, ~std::uint64_t{0});
    words.back() = 0;
    Words expected(length, ~std::uint64_t{0});
    expected.front() = 0;
    EXPECT_EQ(sorted(sorter, words), expected) << length;
  }
}

TEST(WordSorter, TouchesNothingBesideTheRow) {
  SCOPED_TRACE(describeSeed());
  Random random(82);
  for (const std::size_t length : lengths()) {
    Words words = wordsWith(
        length + 2, [&](std::size_t) { return static_cast<std::uint32_t>(random.below(1000)); });
    const Words before = words;
    WordSorter sorter;
    sorter.sort(std::span(words).subspan(1, length));
    EXPECT_EQ(words.front(), before.front()) << length;
    EXPECT_EQ(words.back(), before.back()) << length;
  }
}

TEST(OrderedBits, AreOrderedAsTheFloatsAre) {
  SCOPED_TRACE(describeSeed());
  using Limits = std::numeric_limits<float>;
  Random random(83);
  std::vector<float> values = {-Limits::infinity(),
                               Limits::lowest(),
                               -1.0f,
                               -Limits::min(),
                               -Limits::denorm_min(),
                               0.0f,
                               Limits::denorm_min(),
                               Limits::min(),
                               std::nextafter(1.0f, 0.0f),
                               1.0f,
                               Limits::max(),
                               Limits::infinity()};
  for (int i = 0; i < 200; ++i)
    values.push_back(static_cast<float>(std::ldexp(random.between(-1, 1), i % 80 - 40)));
  for (const float a : values) {
    for (const float b : values) {
      EXPECT_EQ(orderedBits(a) < orderedBits(b), a < b) << a << " and " << b;
      EXPECT_EQ(orderedBits(a) == orderedBits(b), a == b) << a << " and " << b;
    }
  }
}

TEST(OrderedBits, AreTheSameForBothZeros) {
  EXPECT_EQ(orderedBits(-0.0f), orderedBits(0.0f));
}

TEST(OrderedBits, GiveTheFloatBack) {
  using Limits = std::numeric_limits<float>;
  for (const float value : {-Limits::infinity(), Limits::lowest(), -2.5f, -Limits::denorm_min(),
                            0.0f, Limits::denorm_min(), 2.5f, Limits::max(), Limits::infinity()}) {
    const float back = fromOrderedBits(orderedBits(value));
    EXPECT_EQ(std::bit_cast<std::uint32_t>(back), std::bit_cast<std::uint32_t>(value)) << value;
  }
  EXPECT_EQ(std::bit_cast<std::uint32_t>(fromOrderedBits(orderedBits(-0.0f))), 0u);
}

}  // namespace
}  // namespace planetree::detail
