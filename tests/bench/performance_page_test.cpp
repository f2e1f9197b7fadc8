#include "bench/report/performance_page.hpp"

#include "bench/report/bar_chart.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace planetree::bench {
namespace {

std::vector<Result> someResults() {
  std::vector<Result> results;
  const auto add = [&](const char* measure, const char* kind, const char* engine, const char* mode,
                       double value) {
    results.push_back({"a<b|c", measure, kind, engine, mode, 1, value, true, "abc123", "g++ 1.2"});
  };
  for (const char* kind : {"primary", "ao"}) {
    add("mrays_per_second", kind, "planetree", "balanced-watertight", 6.0);
    add("mrays_per_second", kind, "embree3", "medium", 3.0);
    add("mrays_per_second", kind, "embree3", "high", 4.0);
    add("mrays_per_second", kind, "embree3", "high-robust", 2.0);
  }
  add("build_seconds", "", "planetree", "balanced-watertight", 0.5);
  add("build_seconds", "", "embree3", "high", 0.25);
  return results;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(PerformanceFigures, NameMachineCompilerAndCommit) {
  const auto figures = performanceFigures(someResults(), "a machine", "plots");
  EXPECT_TRUE(contains(figures.markdown, "Machine: a machine. Compiler: g++ 1.2. Commit: abc123."));
}

TEST(PerformanceFigures, HaveATableForEachMeasureWithRatiosAndMeans) {
  const std::string text = performanceFigures(someResults(), "", "plots").markdown;
  EXPECT_TRUE(contains(text, "### Million rays per second, more is better (1 thread)"));
  EXPECT_TRUE(contains(text, "### Seconds to build, less is better (1 thread)"));
  EXPECT_TRUE(contains(text, "| a<b\\|c | primary | **6.00** | 3.00 (2.0x) | 4.00 (1.5x) |"));
  EXPECT_TRUE(contains(text, "| geometric mean | | 1.0x | 2.0x | 1.5x | 3.0x |")) << text;
  EXPECT_TRUE(contains(text, "| a<b\\|c | **0.500** | 0.250 (0.50x) |")) << text;
}

TEST(PerformanceFigures, ShowEveryPlotThatIsWritten) {
  const auto figures = performanceFigures(someResults(), "", "some/plots");
  ASSERT_EQ(figures.plots.size(), 3u);
  for (const Plot& plot : figures.plots)
    EXPECT_TRUE(contains(figures.markdown, "](some/plots/" + plot.name + ")")) << plot.name;
}

TEST(PerformanceFigures, PlotTheBestQualityOfARivalOnceForEachVariant) {
  const Plot plot = performanceFigures(someResults(), "", "plots").plots.front();
  EXPECT_TRUE(contains(plot.svg, ">embree3, best<"));
  EXPECT_TRUE(contains(plot.svg, ">embree3-robust, best<"));
  EXPECT_TRUE(contains(plot.svg, ">4.00<"));
  EXPECT_FALSE(contains(plot.svg, ">3.00<"));
}

TEST(PerformanceFigures, HaveStepsInTablesOnly) {
  std::vector<Result> results = someResults();
  results.push_back(
      {"a", "node_steps_per_ray", "ao", "planetree", "balanced-watertight", 1, 20.5, true, "", ""});
  const auto figures = performanceFigures(results, "", "plots");
  EXPECT_TRUE(contains(figures.markdown, "### Nodes visited per ray, less is better (1 thread)"));
  EXPECT_TRUE(contains(figures.markdown, "| a | ao | **20.5** |"));
  EXPECT_EQ(figures.plots.size(), 3u);
}

TEST(PerformanceFigures, ShowBatchesBesideTheBestOfARival) {
  std::vector<Result> results = someResults();
  const auto add = [&](const char* measure, const char* engine, const char* mode, double value) {
    results.push_back({"a", measure, "ao", engine, mode, 2, value, true, "", ""});
  };
  add("batch_mrays_per_second", "planetree", "balanced-watertight", 6.0);
  add("batch_mrays_per_second", "embree3", "medium-packets", 2.0);
  add("batch_mrays_per_second", "embree3", "high-packets", 3.0);
  add("nanoseconds_one_by_one", "planetree", "balanced-watertight", 100.0);
  add("nanoseconds_of_a_batch_of_8", "planetree", "balanced-watertight", 810.0);
  const auto figures = performanceFigures(results, "", "plots");
  const std::string& text = figures.markdown;
  EXPECT_TRUE(contains(text, "### Million rays per second in batches, more is better (2 threads)"));
  EXPECT_TRUE(contains(text, "### How many times more rays planetree traces in batches than"));
  EXPECT_TRUE(contains(text, "| a | 2.0x (high-packets) | 2.0x |")) << text;
  EXPECT_TRUE(contains(text, "| a ao balanced-watertight | 100 | - | 10.0 of 65.0 | - |")) << text;
  EXPECT_FALSE(contains(text, "nanoseconds_")) << "small batches are in one table";
  ASSERT_EQ(figures.plots.size(), 4u);
  EXPECT_TRUE(contains(text, "](plots/batch_mrays_per_second-ao-2.svg)"));
  EXPECT_TRUE(contains(figures.plots.back().svg, ">embree3-packets, best<"));
}

TEST(PerformanceFigures, CompareAcrossThreadsAndSizes) {
  std::vector<Result> results = someResults();
  results.push_back(
      {"a<b|c", "build_seconds", "", "planetree", "balanced-watertight", 2, 0.25, true, "", ""});
  results.push_back({"terrain-10k", "build_seconds", "", "planetree", "balanced-watertight", 2, 0.1,
                     true, "", "", 10'000});
  const std::string text = performanceFigures(results, "", "plots").markdown;
  EXPECT_TRUE(contains(text, "### How many times better the presets are"));
  EXPECT_TRUE(contains(text, "### How many times faster 2 threads build than 1\n"));
  EXPECT_TRUE(contains(text, "| a<b\\|c | 2.0x |"));
  EXPECT_TRUE(contains(text, "### Nanoseconds to build for each triangle of terrain"));
  EXPECT_FALSE(contains(text, "| terrain-10k |")) << "it is only in the table of sizes";
}

TEST(WithFigures, ReplacesOnlyWhatIsBetweenTheMarks) {
  const std::string page = "before\n<!-- figures: begin -->\nold\n<!-- figures: end -->\nafter\n";
  const std::string once = withFigures(page, "new\n", "page.md");
  EXPECT_EQ(once, "before\n<!-- figures: begin -->\n\nnew\n\n<!-- figures: end -->\nafter\n");
  EXPECT_EQ(withFigures(once, "new\n", "page.md"), once);
}

TEST(WithFigures, RefusesAPageWithoutMarks) {
  for (const char* page : {"", "<!-- figures: begin -->", "<!-- figures: end -->",
                           "<!-- figures: end --><!-- figures: begin -->"}) {
    try {
      (void)withFigures(page, "new", "page.md");
      ADD_FAILURE() << "accepted " << page;
    } catch (const Error& error) {
      EXPECT_EQ(error.file(), "page.md");
    }
  }
}

TEST(BarChart, IsWellFormedWhateverTheNames) {
  const BarChart chart = {.title = "a < b & c",
                          .series = {"one", "<two>"},
                          .groups = {{"g&h", {1.0, std::nullopt}}, {"zero", {0.0, 0.0}}}};
  const std::string svg = toSvg(chart);
  EXPECT_TRUE(svg.starts_with("<svg "));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_TRUE(contains(svg, "a &lt; b &amp; c"));
  EXPECT_TRUE(contains(svg, "&lt;two&gt;"));
  EXPECT_EQ(occurrences(svg, "<text"), occurrences(svg, "</text>"));
  // Background, two keys, and three bars: what is unknown has none.
  EXPECT_EQ(occurrences(svg, "<rect"), 6u);
  EXPECT_FALSE(contains(svg, "nan"));
}

TEST(BarChart, KeysTakeAsManyLinesAsTheyNeed) {
  BarChart chart = {.title = "", .series = {"short", "names"}, .groups = {{"a", {1.0, 1.0}}}};
  EXPECT_EQ(occurrences(toSvg(chart), "y=\"46\""), 2u);
  chart.series = {std::string(60, 'x'), std::string(60, 'y')};
  EXPECT_EQ(occurrences(toSvg(chart), "y=\"46\""), 1u);
  EXPECT_EQ(occurrences(toSvg(chart), "y=\"62\""), 1u);
}

TEST(BarChart, LongestBarIsThatOfTheGroupOrOfAll) {
  BarChart chart = {.title = "", .series = {"s"}, .groups = {{"a", {1.0}}, {"b", {10.0}}}};
  EXPECT_EQ(occurrences(toSvg(chart), "width=\"500.0\""), 1u);
  EXPECT_EQ(occurrences(toSvg(chart), "width=\"50.0\""), 1u);
  chart.scalesEachGroup = true;
  EXPECT_EQ(occurrences(toSvg(chart), "width=\"500.0\""), 2u);
}

}  // namespace
}  // namespace planetree::bench
