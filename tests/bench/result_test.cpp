#include "bench/support/result.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace planetree::bench {
namespace {

const Result kResult = {.scene = "bunny",
                        .measure = "mrays_per_second",
                        .kind = "ao",
                        .engine = "embree3",
                        .mode = "high-robust",
                        .threadCount = 2,
                        .value = 4.125,
                        .isDefault = false,
                        .commit = "0123456789",
                        .compiler = "g++ 12.2.0",
                        .objectCount = 69451};

TEST(ResultJson, HasTheDocumentedKeys) {
  EXPECT_EQ(toJson({kResult}),
            "[\n  {\"scene\":\"bunny\",\"measure\":\"mrays_per_second\",\"kind\":\"ao\","
            "\"engine\":\"embree3\",\"mode\":\"high-robust\",\"threads\":2,\"value\":4.125,"
            "\"default\":false,\"commit\":\"0123456789\",\"compiler\":\"g++ "
            "12.2.0\",\"objects\":69451}\n]\n");
}

TEST(ResultJson, OlderFilesDoNotTellHowManyObjectsThereAre) {
  std::string json = toJson({kResult});
  json.replace(json.find(",\"objects\":69451"), 16, "");
  Result older = kResult;
  older.objectCount = 0;
  EXPECT_EQ(resultsFromJson(json, "file"), std::vector<Result>{older});
}

TEST(ResultJson, ComesBackAsItWas) {
  Result odd = kResult;
  odd.scene = "a \"b\" \\ c|d";
  odd.value = 1.0 / 3.0;
  odd.isDefault = true;
  const std::vector<Result> all = {kResult, odd};
  EXPECT_EQ(resultsFromJson(toJson(all), "file"), all);
  EXPECT_TRUE(resultsFromJson(toJson({}), "file").empty());
}

TEST(ResultJson, ReplacesWhatIsNotUtf8) {
  Result result = kResult;
  result.scene = "caf\xe9";
  EXPECT_EQ(resultsFromJson(toJson({result}), "file").front().scene, "caf\xef\xbf\xbd");
}

TEST(ResultJson, RefusesWhatItWouldNotWrite) {
  for (const char* json : {"", "[", "{}x", "7", "[{}]", "[7]", "[{\"scene\":1}]", "{\"a\":1}"}) {
    try {
      (void)resultsFromJson(json, "some.json");
      ADD_FAILURE() << "accepted " << json;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::MalformedFile);
      EXPECT_EQ(error.file(), "some.json");
    }
  }
}

}  // namespace
}  // namespace planetree::bench
