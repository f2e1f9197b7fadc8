#include "bench/support/picture_tables.hpp"

#include "bench/report/performance_page.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace planetree::bench {
namespace {

using Row = std::vector<std::string>;

void addRun(std::vector<Result>& results, const std::string& scene, unsigned threadCount,
            double rendering) {
  const auto add = [&](std::string_view measure, double value) {
    Result result;
    result.scene = scene;
    result.measure = measure;
    result.kind = "whitted";
    result.threadCount = threadCount;
    result.value = value;
    results.push_back(result);
  };
  add(kPictureReadingSeconds, 0.010);
  add(kPictureBuildingSeconds, 0.020);
  add(kPictureTracingSeconds, 0.75 * rendering);
  add(kPictureShadingSeconds, 0.25 * rendering);
  add(kPictureEncodingSeconds, 0.070);
  add(kPictureRays, 1e6);
}

std::vector<Result> twoPictures() {
  std::vector<Result> results;
  addRun(results, "sea.ray", 1, 0.4);
  addRun(results, "sea.ray", 2, 0.2);
  addRun(results, "bunny.obj", 1, 0.9);
  addRun(results, "bunny.obj", 2, 0.6);
  return results;
}

TEST(PictureTables, SayHowManyTimesFasterMoreThreadsAre) {
  const auto tables = pictureTables(twoPictures());
  ASSERT_EQ(tables.size(), 2u);
  const auto& rows = tables[0].rows;
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0], (Row{"sea.ray, whitted", "1", "400.0", "", "2.50", "75", "25"}));
  EXPECT_EQ(rows[1], (Row{"sea.ray, whitted", "2", "200.0", "2.00x", "5.00", "75", "25"}));
  EXPECT_EQ(rows[3][3], "1.50x");
  EXPECT_EQ(rows[4], (Row{"geometric mean", "", "", "1.73x", "", "", ""}));
  EXPECT_EQ(rows[5], (Row{"least", "", "", "1.50x", "", "", ""}));
}

TEST(PictureTables, AddUpAllPartsOfARun) {
  const auto rows = pictureTables(twoPictures()).at(1).rows;
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0],
            (Row{"sea.ray, whitted", "1", "10.0", "20.0", "300.0", "100.0", "70.0", "500.0", ""}));
  EXPECT_EQ(rows[1], (Row{"sea.ray, whitted", "2", "10.0", "20.0", "150.0", "50.0", "70.0", "300.0",
                          "1.67x"}));
}

TEST(PictureTables, TakeWhatWasOnlyReadAndBuilt) {
  std::vector<Result> results = twoPictures();
  std::erase_if(results, [](const Result& result) {
    return result.measure != kPictureReadingSeconds && result.measure != kPictureBuildingSeconds;
  });
  const auto tables = pictureTables(results);
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].rows[0],
            (Row{"sea.ray, whitted", "1", "10.0", "20.0", "-", "-", "-", "30.0", ""}));
}

TEST(PictureTables, AreOnThePageInPlaceOfATableForEachMeasure) {
  const std::string page = performanceFigures(twoPictures(), "a machine", "plots").markdown;
  EXPECT_NE(page.find("| sea.ray, whitted | 2 | 200.0 | 2.00x |"), std::string::npos) << page;
  EXPECT_EQ(page.find("picture_"), std::string::npos) << page;
  EXPECT_TRUE(performanceFigures(twoPictures(), "a machine", "plots").plots.empty());
}

TEST(PictureTables, AreNotThereWithoutPictures) {
  EXPECT_TRUE(pictureTables({}).empty());
  EXPECT_TRUE(withoutPictures(twoPictures()).empty());
}

}  // namespace
}  // namespace planetree::bench
