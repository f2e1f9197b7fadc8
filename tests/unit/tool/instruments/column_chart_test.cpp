#include "instruments/column_chart.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace planetree::tool {
namespace {

using Ticks = std::vector<double>;

TEST(AxisTicks, AreRoundNumbersThatReachTheHighestValue) {
  EXPECT_EQ(axisTicks(4.3, false), (Ticks{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(axisTicks(10.0, false), (Ticks{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(axisTicks(17'801.0, true), (Ticks{0, 5000, 10'000, 15'000, 20'000}));
}

TEST(AxisTicks, OfCountsAreWholeNumbers) {
  EXPECT_EQ(axisTicks(1.0, true), (Ticks{0, 1}));
  EXPECT_EQ(axisTicks(3.0, true), (Ticks{0, 1, 2, 3}));
  EXPECT_EQ(axisTicks(0.5, false).size(), 6u);
}

TEST(AxisTicks, HaveAnEndWhereAllIsZero) {
  for (const bool isWhole : {false, true}) {
    const Ticks ticks = axisTicks(0.0, isWhole);
    EXPECT_GE(ticks.size(), 2u);
    EXPECT_GT(ticks.back(), 0.0);
  }
}

TEST(AxisTicks, AreFewForAnyMagnitude) {
  for (double highest = 1e-12; highest < 1e18; highest *= 1.37) {
    const Ticks ticks = axisTicks(highest, false);
    EXPECT_GE(ticks.back(), highest);
    EXPECT_GE(ticks.size(), 3u) << highest;
    EXPECT_LE(ticks.size(), 7u) << highest;
  }
}

TEST(XmlText, EscapesWhatXmlCannotHold) {
  EXPECT_EQ(xmlText("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;");
  EXPECT_EQ(xmlText("ä – █"), "ä – █");
  EXPECT_EQ(xmlText("\x01\n\xff"), "\uFFFD\uFFFD\uFFFD");
}

}  // namespace
}  // namespace planetree::tool
