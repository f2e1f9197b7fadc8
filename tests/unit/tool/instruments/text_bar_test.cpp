#include "instruments/text_bar.hpp"

#include <gtest/gtest.h>

namespace planetree::tool {
namespace {

TEST(TextBar, GrowsInEighthsOfAColumn) {
  EXPECT_EQ(textBar(8.0, 8.0, 2), "██");
  EXPECT_EQ(textBar(4.0, 8.0, 2), "█");
  EXPECT_EQ(textBar(6.0, 8.0, 2), "█▌");
  EXPECT_EQ(textBar(1.0, 16.0, 2), "▏");
}

TEST(TextBar, ShowsWhatIsNotZero) {
  EXPECT_EQ(textBar(1.0, 1e9, 10), "▏");
  EXPECT_EQ(textBar(0.0, 1e9, 10), "");
  EXPECT_EQ(textBar(0.0, 0.0, 10), "");
}

TEST(ColumnCount, CountsCharactersNotBytes) {
  EXPECT_EQ(columnCount(""), 0u);
  EXPECT_EQ(columnCount("abc"), 3u);
  EXPECT_EQ(columnCount("8–15 █▌"), 7u);
}

TEST(Padded, FillsWithBlanks) {
  EXPECT_EQ(padded("█▌", 4), "█▌  ");
  EXPECT_EQ(paddedLeft("8–15", 6), "  8–15");
  EXPECT_EQ(padded("long", 2), "long");
}

TEST(Shortened, EndsWithAnEllipsisIfSomethingIsMissing) {
  EXPECT_EQ(shortened("bunny.obj", 9), "bunny.obj");
  EXPECT_EQ(shortened("bunny.obj", 8), "bunny.o…");
  EXPECT_EQ(shortened("äöüäöü", 4), "äöü…");
  EXPECT_EQ(columnCount(shortened("äöüäöü", 1)), 1u);
  EXPECT_EQ(shortened("\x80\x80\x80", 2), "\x80\x80\x80") << "bytes that are no UTF-8 do no harm";
}

}  // namespace
}  // namespace planetree::tool
