#include "bench/support/comparisons.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace planetree::bench {
namespace {

struct Cell {
  std::string scene;
  std::string engine;
  std::string mode;
  double value = 0.0;
  unsigned threadCount = 2;
  std::string measure = "build_seconds";
  std::uint64_t objectCount = 0;
  std::string kind = {};
};

std::vector<Result> resultsOf(const std::vector<Cell>& cells) {
  std::vector<Result> results;
  for (const Cell& cell : cells) {
    results.push_back({.scene = cell.scene,
                       .measure = cell.measure,
                       .kind = cell.kind,
                       .engine = cell.engine,
                       .mode = cell.mode,
                       .threadCount = cell.threadCount,
                       .value = cell.value,
                       .isDefault = cell.mode == "balanced-watertight",
                       .commit = "",
                       .compiler = "",
                       .objectCount = cell.objectCount});
  }
  return results;
}

using Row = std::vector<std::string>;

TEST(Comparisons, PutEachPresetBesideItsCounterpart) {
  const auto tables = comparisons(resultsOf({{"a", "planetree", "balanced-watertight", 1.0},
                                             {"a", "planetree", "fast-watertight", 0.5},
                                             {"a", "embree3", "medium", 0.25},
                                             {"a", "embree3", "high", 2.0},
                                             {"b", "planetree", "balanced-watertight", 1.0},
                                             {"b", "planetree", "fast-watertight", 0.5},
                                             {"b", "embree3", "medium", 1.0},
                                             {"b", "embree3", "high", 8.0}}));
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].header, (Row{"measure", "fast / embree3 medium", "balanced / embree3 high",
                                   "high / embree3 high"}));
  ASSERT_EQ(tables[0].rows.size(), 1u);
  EXPECT_EQ(tables[0].rows[0],
            (Row{"seconds to build, less is better (2 threads)", "1.0x", "4.0x", "-"}));
}

TEST(Comparisons, MoreRaysAreBetter) {
  const auto tables =
      comparisons(resultsOf({{"a", "planetree", "high-watertight", 6.0, 1, "mrays_per_second"},
                             {"a", "embree3", "high", 3.0, 1, "mrays_per_second"}}));
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].rows[0].back(), "2.0x");
}

TEST(Comparisons, TellHowMuchFasterMoreThreadsAre) {
  const auto tables =
      comparisons(resultsOf({{"a", "planetree", "balanced-watertight", 2.0, 1},
                             {"a", "planetree", "fast-watertight", 1.5, 1},
                             {"b", "planetree", "balanced-watertight", 8.0, 1},
                             {"only-one", "planetree", "fast-watertight", 1.0, 1},
                             {"a", "planetree", "balanced-watertight", 1.0, 2},
                             {"a", "planetree", "fast-watertight", 1.0, 2},
                             {"b", "planetree", "balanced-watertight", 2.0, 2},
                             {"only-two", "planetree", "fast-watertight", 1.0, 2}}));
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].title, "how many times faster 2 threads build than 1");
  EXPECT_EQ(tables[0].header,
            (Row{"scene", "planetree balanced-watertight", "planetree fast-watertight"}));
  EXPECT_EQ(tables[0].rows, (std::vector<Row>{{"a", "2.0x", "1.5x"},
                                              {"b", "4.0x", "-"},
                                              {"geometric mean", "2.8x", "1.5x"},
                                              {"worst scene", "2.0x", "1.5x"}}));
}

/// Million rays per second of batches.
Cell batch(const std::string& scene, const std::string& kind, const std::string& mode, double value,
           unsigned threadCount = 1) {
  return {.scene = scene,
          .engine = mode == "balanced-watertight" ? "planetree" : "embree3",
          .mode = mode,
          .value = value,
          .threadCount = threadCount,
          .measure = "batch_mrays_per_second",
          .kind = kind};
}

TEST(Comparisons, PutBatchesBesideTheBestOfEmbreeForEachCell) {
  const auto tables = comparisons(resultsOf(
      {batch("a", "primary", "balanced-watertight", 20.0), batch("a", "primary", "high", 5.0),
       batch("a", "primary", "high-packets", 10.0), batch("a", "ao", "balanced-watertight", 6.0),
       batch("a", "ao", "high", 4.0), batch("a", "ao", "high-packets", 2.0),
       batch("b", "primary", "balanced-watertight", 4.0),
       batch("b", "primary", "high-packets", 8.0), batch("b", "random", "balanced-watertight", 6.0),
       batch("b", "random", "high", 1.0), batch("alone", "ao", "balanced-watertight", 6.0)}));
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].title,
            "how many times more rays planetree traces in batches than the best mode of embree3; "
            "1 thread");
  EXPECT_EQ(tables[0].header, (Row{"scene", "primary", "ao", "random", "all but primary"}));
  EXPECT_EQ(tables[0].rows,
            (std::vector<Row>{{"a", "2.0x (high-packets)", "1.5x (high)", "-", "1.5x"},
                              {"b", "0.50x (high-packets)", "-", "6.0x (high)", "6.0x"},
                              {"geometric mean", "1.0x", "1.5x", "6.0x", "3.0x"},
                              {"worst", "0.50x", "1.5x", "6.0x", "1.5x"}}));
}

TEST(Comparisons, TellHowMuchFasterMoreThreadsTraceBatches) {
  const auto tables = comparisons(resultsOf({batch("a", "primary", "balanced-watertight", 10.0),
                                             batch("a", "ao", "balanced-watertight", 10.0),
                                             batch("b", "ao", "balanced-watertight", 10.0),
                                             batch("a", "primary", "balanced-watertight", 20.0, 2),
                                             batch("a", "ao", "balanced-watertight", 12.8, 2),
                                             batch("b", "ao", "balanced-watertight", 10.0, 2)}));
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].title, "how many times faster 2 threads trace batches than 1");
  EXPECT_EQ(
      tables[0].rows,
      (std::vector<Row>{
          {"a", "1.6x"}, {"b", "1.0x"}, {"geometric mean", "1.3x"}, {"worst scene", "1.0x"}}));
}

TEST(Comparisons, TellWhatSmallBatchesTakeMoreThanTheirRays) {
  const auto cell = [](const std::string& kind, const std::string& measure, double value) {
    return Cell{.scene = "a",
                .engine = "planetree",
                .mode = "balanced-watertight",
                .value = value,
                .threadCount = 1,
                .measure = measure,
                .kind = kind};
  };
  const auto tables =
      comparisons(resultsOf({cell("ao", "nanoseconds_one_by_one", 100.0),
                             cell("ao", "nanoseconds_of_a_batch_of_1", 131.0),
                             cell("ao", "nanoseconds_of_a_batch_of_8", 860.0),
                             cell("ao", "nanoseconds_of_a_batch_of_64", 3200.0),
                             cell("random", "nanoseconds_one_by_one", 200.0),
                             cell("random", "nanoseconds_of_a_batch_of_1", 210.0)}));
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].header,
            (Row{"scene, rays and mode", "one ray", "batch of 1", "batch of 8", "batch of 64"}));
  EXPECT_EQ(tables[0].rows,
            (std::vector<Row>{{"a ao balanced-watertight", "100", "31.0 of 30.0", "60.0 of 65.0",
                               "-3200.0 of 345.0"},
                              {"a random balanced-watertight", "200", "10.0 of 35.0", "-", "-"},
                              {"as allowed", "", "1 of 2", "1 of 1", "1 of 1"}}));
}

TEST(Comparisons, TellWhatATriangleCostsInScenesOfEachSize) {
  const auto tables = comparisons(resultsOf(
      {{"terrain-1m", "planetree", "balanced-watertight", 0.3, 2, "build_seconds", 1'000'000},
       {"bunny", "planetree", "balanced-watertight", 0.3, 2, "build_seconds", 69'451},
       {"terrain-1k", "planetree", "balanced-watertight", 1e-4, 2, "build_seconds", 1'000},
       {"terrain-1k", "planetree", "balanced-watertight", 5.0, 2, "peak_bytes_per_triangle", 1'000},
       {"scatter-2k", "planetree", "balanced-watertight", 1e-3, 2}}));
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_NE(tables[0].title.find("scatter"), std::string::npos);
  EXPECT_EQ(tables[0].rows, (std::vector<Row>{{"2000", "1.0x", "500 (1.0x)"}}))
      << "by its name, where the results do not say how many triangles there are";
  EXPECT_NE(tables[1].title.find("terrain"), std::string::npos);
  EXPECT_EQ(tables[1].header, (Row{"triangles", "log N", "planetree balanced-watertight"}));
  EXPECT_EQ(tables[1].rows,
            (std::vector<Row>{{"1000", "1.0x", "100 (1.0x)"}, {"1000000", "2.0x", "300 (3.0x)"}}));
}

TEST(Comparisons, AreNoneWhereThereIsNothingToCompare) {
  EXPECT_TRUE(comparisons({}).empty());
  EXPECT_TRUE(comparisons(resultsOf({{"a", "planetree", "balanced-watertight", 1.0}})).empty());
}

TEST(Table, IsAlignedInTextAndEscapedInMarkdown) {
  const Table table = {.title = "title", .header = {"a", "b"}, .rows = {{"left|", "1"}}};
  EXPECT_EQ(toText(table), "title\na      b\nleft|  1\n");
  EXPECT_EQ(toMarkdown(table), "| a | b |\n| --- | ---: |\n| left\\| | 1 |\n");
}

}  // namespace
}  // namespace planetree::bench
