#include "bench/support/result.hpp"

#include <planetree/error.hpp>

#include <nlohmann/json.hpp>

namespace planetree::bench {

namespace {

/// Keeps the keys in the order they were added.
using Json = nlohmann::ordered_json;

Json toObject(const Result& result) {
  return {{"scene", result.scene},        {"measure", result.measure},
          {"kind", result.kind},          {"engine", result.engine},
          {"mode", result.mode},          {"threads", result.threadCount},
          {"value", result.value},        {"default", result.isDefault},
          {"commit", result.commit},      {"compiler", result.compiler},
          {"objects", result.objectCount}};
}

Result fromObject(const Json& object) {
  Result result;
  object.at("scene").get_to(result.scene);
  object.at("measure").get_to(result.measure);
  object.at("kind").get_to(result.kind);
  object.at("engine").get_to(result.engine);
  object.at("mode").get_to(result.mode);
  object.at("threads").get_to(result.threadCount);
  object.at("value").get_to(result.value);
  object.at("default").get_to(result.isDefault);
  object.at("commit").get_to(result.commit);
  object.at("compiler").get_to(result.compiler);
  if (object.contains("objects"))
    object.at("objects").get_to(result.objectCount);
  return result;
}

}  // namespace

std::string toJson(const std::vector<Result>& results) {
  // File names need not be UTF-8, but JSON must be.
  constexpr auto kReplace = Json::error_handler_t::replace;
  std::string json = "[";
  for (const Result& result : results) {
    json += json.size() == 1 ? "\n  " : ",\n  ";
    json += toObject(result).dump(-1, ' ', false, kReplace);
  }
  return json + "\n]\n";
}

std::vector<Result> resultsFromJson(const std::string& json, const std::string& file) {
  try {
    std::vector<Result> results;
    for (const Json& object : Json::parse(json))
      results.push_back(fromObject(object));
    return results;
  } catch (const nlohmann::json::exception& error) {
    throw Error(ErrorCode::MalformedFile,
                std::string("no results of the benchmark: ") + error.what(),
                "Write it with planetree-bench rivals --json.", {.file = file});
  }
}

}  // namespace planetree::bench
