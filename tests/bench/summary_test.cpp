#include "bench/support/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace planetree::bench {
namespace {

Result result(const std::string& scene, const std::string& engine, double value,
              const std::string& measure = "mrays_per_second") {
  return {.scene = scene,
          .measure = measure,
          .kind = measure == "mrays_per_second" ? "ao" : "",
          .engine = engine,
          .mode = "mode",
          .threadCount = 1,
          .value = value,
          .isDefault = true,
          .commit = "",
          .compiler = ""};
}

TEST(Summary, RatioAboveOneMeansThatPlanetreeLeads) {
  const auto rays = summarise({result("a", "planetree", 6.0), result("a", "embree3", 3.0)});
  EXPECT_EQ(rays.front().rows.front().ratios[1], 2.0);
  const auto seconds = summarise({result("a", "planetree", 6.0, "build_seconds"),
                                  result("a", "embree3", 3.0, "build_seconds")});
  EXPECT_EQ(seconds.front().rows.front().ratios[1], 0.5);
}

TEST(Summary, MeansAreGeometric) {
  const auto summaries = summarise({result("a", "planetree", 6.0), result("a", "embree3", 3.0),
                                    result("b", "planetree", 4.0), result("b", "embree3", 0.5)});
  ASSERT_EQ(summaries.size(), 1u);
  EXPECT_DOUBLE_EQ(*summaries[0].meanRatios[0], 1.0);
  EXPECT_DOUBLE_EQ(*summaries[0].meanRatios[1], 4.0);
}

TEST(Summary, KeepsMeasuresAndThreadCountsApart) {
  Result threaded = result("a", "planetree", 11.0);
  threaded.threadCount = 2;
  const auto summaries = summarise(
      {result("a", "planetree", 6.0), threaded, result("a", "planetree", 1.0, "build_seconds")});
  ASSERT_EQ(summaries.size(), 3u);
  EXPECT_EQ(summaries[1].threadCount, 2u);
  EXPECT_EQ(summaries[2].measure, "build_seconds");
}

TEST(Summary, LeavesOutWhatWasNotMeasured) {
  const auto summaries = summarise({result("a", "planetree", 6.0), result("a", "embree3", 3.0),
                                    result("b", "planetree", 4.0), result("c", "embree3", 1.0)});
  const Summary& summary = summaries.front();
  EXPECT_FALSE(summary.rows[1].values[1]);
  EXPECT_FALSE(summary.rows[2].values[0]);
  EXPECT_FALSE(summary.rows[2].ratios[1]);
  EXPECT_DOUBLE_EQ(*summary.meanRatios[1], 2.0);
  EXPECT_NE(toText(summary).find("-"), std::string::npos);
}

TEST(Summary, HasNoRatiosWithoutPlanetree) {
  const auto summaries = summarise({result("a", "embree3", 3.0)});
  EXPECT_FALSE(summaries.front().reference);
  EXPECT_FALSE(summaries.front().meanRatios[0]);
  EXPECT_EQ(toText(summaries.front()).find("geometric"), std::string::npos);
}

TEST(Summary, TextShowsEveryCellRatioAndMean) {
  const auto summaries = summarise({result("a", "planetree", 6.0), result("a", "embree3", 3.0),
                                    result("b", "planetree", 4.0), result("b", "embree3", 0.5)});
  const std::string text = toText(summaries.front());
  for (const char* part : {"million rays per second", "1 thread", "planetree", "embree3", "mode*",
                           "6.00", "3.00", "2.0x", "0.500", "8.0x", "geometric mean", "4.0x"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is missing from\n" << text;
}

TEST(RatioText, HasTwoDigitsThatCount) {
  EXPECT_EQ(ratioText(0.0123456), "0.012x");
  EXPECT_EQ(ratioText(0.448), "0.45x");
  EXPECT_EQ(ratioText(1.04), "1.0x");
  EXPECT_EQ(ratioText(123.4), "123x");
}

TEST(ValueText, HasThreeDigitsThatCount) {
  EXPECT_EQ(valueText(0.0123456), "0.0123");
  EXPECT_EQ(valueText(4.561), "4.56");
  EXPECT_EQ(valueText(78.94), "78.9");
  EXPECT_EQ(valueText(1234.4), "1234");
  EXPECT_EQ(valueText(0.0), "0");
}

}  // namespace
}  // namespace planetree::bench
