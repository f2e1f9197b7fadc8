#include "bench/support/picture_tables.hpp"

#include "bench/support/mean.hpp"
#include "bench/support/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace planetree::bench {

namespace {

/// The measures of one picture with one number of threads.
class Run {
 public:
  void add(const Result& result) { values_[result.measure] = result.value; }

  [[nodiscard]] std::optional<double> value(std::string_view measure) const {
    const auto found = values_.find(measure);
    return found != values_.end() ? std::optional(found->second) : std::nullopt;
  }
  [[nodiscard]] double seconds(std::string_view measure) const {
    return value(measure).value_or(0.0);
  }
  [[nodiscard]] bool isRendered() const { return value(kPictureTracingSeconds).has_value(); }
  [[nodiscard]] double renderingSeconds() const {
    return seconds(kPictureTracingSeconds) + seconds(kPictureShadingSeconds);
  }
  [[nodiscard]] double allSeconds() const {
    return seconds(kPictureReadingSeconds) + seconds(kPictureBuildingSeconds) + renderingSeconds() +
           seconds(kPictureEncodingSeconds);
  }

 private:
  std::map<std::string, double, std::less<>> values_;
};

/// A picture, and its runs by their number of threads.
struct Picture {
  std::string scene;
  std::string kind;
  std::map<unsigned, Run> runs = {};

  /// "bunny, ao"
  [[nodiscard]] std::string name() const { return kind.empty() ? scene : scene + ", " + kind; }
};

std::vector<Picture> picturesOf(const std::vector<Result>& results) {
  std::vector<Picture> pictures;
  for (const Result& result : results) {
    if (!isOfPictures(result.measure))
      continue;
    auto known = std::find_if(pictures.begin(), pictures.end(), [&](const Picture& picture) {
      return picture.scene == result.scene && picture.kind == result.kind;
    });
    if (known == pictures.end())
      known = pictures.insert(pictures.end(), {result.scene, result.kind});
    known->runs[result.threadCount].add(result);
  }
  return pictures;
}

std::string millisecondsText(std::optional<double> seconds) {
  return seconds ? fmt::format("{:.1f}", *seconds * 1e3) : kNotMeasured;
}

/// Three digits: what matters here is whether it is 1.8 or 1.9.
std::string speedUpText(double ratio) {
  return fmt::format("{:.2f}x", ratio);
}

/// How many times faster `run` is than that with one thread.
std::string speedUpText(const Picture& picture, const Run& run, double (Run::*seconds)() const,
                        Mean* mean) {
  const auto one = picture.runs.find(1);
  if (one == picture.runs.end() || &one->second == &run)
    return "";
  const double ratio = (one->second.*seconds)() / (run.*seconds)();
  if (mean != nullptr)
    mean->add(ratio);
  return speedUpText(ratio);
}

Table renderingTable(const std::vector<Picture>& pictures) {
  Table table;
  table.title = "rendering: milliseconds, how many times faster than 1 thread, and where they go";
  table.header = {"picture",          "threads",   "milliseconds", "faster",
                  "million rays / s", "tracing %", "shading %"};
  Mean mean;
  for (const Picture& picture : pictures) {
    for (const auto& [threads, run] : picture.runs) {
      if (!run.isRendered())
        continue;
      const double seconds = run.renderingSeconds();
      const double tracing = 100.0 * run.seconds(kPictureTracingSeconds) / seconds;
      table.rows.push_back({picture.name(), std::to_string(threads), millisecondsText(seconds),
                            speedUpText(picture, run, &Run::renderingSeconds, &mean),
                            valueText(run.seconds(kPictureRays) / seconds / 1e6),
                            fmt::format("{:.0f}", tracing), fmt::format("{:.0f}", 100 - tracing)});
    }
  }
  if (!mean.isEmpty()) {
    table.rows.push_back({"geometric mean", "", "", speedUpText(mean.value()), "", "", ""});
    table.rows.push_back({"least", "", "", speedUpText(mean.least()), "", "", ""});
  }
  return table;
}

Table wholeTable(const std::vector<Picture>& pictures) {
  Table table;
  table.title = "from the file of a scene to that of its picture: milliseconds";
  table.header = {"picture", "threads",  "reading", "building", "tracing",
                  "shading", "encoding", "all",     "faster"};
  for (const Picture& picture : pictures) {
    for (const auto& [threads, run] : picture.runs) {
      table.rows.push_back({picture.name(), std::to_string(threads)});
      for (const std::string_view measure :
           {kPictureReadingSeconds, kPictureBuildingSeconds, kPictureTracingSeconds,
            kPictureShadingSeconds, kPictureEncodingSeconds})
        table.rows.back().push_back(millisecondsText(run.value(measure)));
      table.rows.back().push_back(millisecondsText(run.allSeconds()));
      table.rows.back().push_back(speedUpText(picture, run, &Run::allSeconds, nullptr));
    }
  }
  return table;
}

}  // namespace

std::vector<Table> pictureTables(const std::vector<Result>& results) {
  const std::vector<Picture> pictures = picturesOf(results);
  std::vector<Table> tables = {renderingTable(pictures), wholeTable(pictures)};
  std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
  return tables;
}

std::vector<Result> withoutPictures(std::vector<Result> results) {
  std::erase_if(results, [](const Result& result) { return isOfPictures(result.measure); });
  return results;
}

}  // namespace planetree::bench
