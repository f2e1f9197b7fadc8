#include "bench/support/comparisons.hpp"

#include "bench/scene/sized_scenes.hpp"
#include "bench/support/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace planetree::bench {

namespace {

constexpr const char* kNotMeasured = "-";

/// A preset, and what a user of Embree would build with for the same end.
struct Counterparts {
  std::string_view preset;
  std::string_view mode;
  std::string_view quality;
};
constexpr Counterparts kCounterparts[] = {{"fast", "fast-watertight", "medium"},
                                          {"balanced", "balanced-watertight", "high"},
                                          {"high", "high-watertight", "high"}};

/// The geometric mean of the numbers added to it.
class Mean {
 public:
  void add(double number) {
    logSum_ += std::log(number);
    ++count_;
  }
  [[nodiscard]] std::string text() const {
    return count_ == 0 ? kNotMeasured : ratioText(std::exp(logSum_ / count_));
  }
  [[nodiscard]] bool isEmpty() const noexcept { return count_ == 0; }

 private:
  double logSum_ = 0.0;
  double count_ = 0.0;
};

std::optional<std::size_t> columnOf(const Summary& summary, std::string_view engine,
                                    std::string_view mode) {
  for (std::size_t i = 0; i < summary.columns.size(); ++i) {
    if (summary.columns[i].engine == engine && summary.columns[i].mode == mode)
      return i;
  }
  return std::nullopt;
}

std::string threadText(unsigned count) {
  return fmt::format("{} {}", count, count == 1 ? "thread" : "threads");
}

std::string nameOf(const Summary::Column& column) {
  return column.engine + " " + column.mode;
}

/// How many times better planetree is, over all rows that have both.
Mean meanLead(const Summary& summary, const Counterparts& pair) {
  Mean mean;
  const auto ours = columnOf(summary, "planetree", pair.mode);
  const auto theirs = columnOf(summary, "embree3", pair.quality);
  if (!ours || !theirs)
    return mean;
  for (const Summary::Row& row : summary.rows) {
    const auto& [a, b] = std::pair(row.values[*ours], row.values[*theirs]);
    if (a && b)
      mean.add(moreIsBetter(summary.measure) ? *a / *b : *b / *a);
  }
  return mean;
}

Table presets(const std::vector<Summary>& summaries) {
  Table table;
  table.title = "how many times better the presets are than their counterparts, geometric means";
  table.header = {"measure"};
  for (const Counterparts& pair : kCounterparts)
    table.header.push_back(fmt::format("{} / embree3 {}", pair.preset, pair.quality));
  for (const Summary& summary : summaries) {
    std::vector<std::string> row = {
        fmt::format("{} ({})", measureTitle(summary.measure), threadText(summary.threadCount))};
    bool isEmpty = true;
    for (const Counterparts& pair : kCounterparts) {
      const Mean mean = meanLead(summary, pair);
      isEmpty = isEmpty && mean.isEmpty();
      row.push_back(mean.text());
    }
    if (!isEmpty)
      table.rows.push_back(std::move(row));
  }
  return table;
}

const Summary::Row* rowOf(const Summary& summary, const std::string& scene) {
  const auto found = std::find_if(summary.rows.begin(), summary.rows.end(),
                                  [&](const Summary::Row& row) { return row.scene == scene; });
  return found != summary.rows.end() ? &*found : nullptr;
}

/// Two summaries of the same measure: with one thread, and with several.
Table speedUp(const Summary& one, const Summary& several) {
  Table table;
  table.title =
      fmt::format("how many times faster {} build than 1", threadText(several.threadCount));
  table.header = {"scene"};
  for (const Summary::Column& column : several.columns)
    table.header.push_back(nameOf(column));
  std::vector<Mean> means(several.columns.size());
  for (const Summary::Row& row : several.rows) {
    const Summary::Row* const alone = rowOf(one, row.scene);
    if (alone == nullptr)
      continue;
    std::vector<std::string> cells = {row.scene};
    for (std::size_t i = 0; i < several.columns.size(); ++i) {
      const auto column = columnOf(one, several.columns[i].engine, several.columns[i].mode);
      if (!column || !alone->values[*column] || !row.values[i]) {
        cells.emplace_back(kNotMeasured);
        continue;
      }
      const double ratio = *alone->values[*column] / *row.values[i];
      means[i].add(ratio);
      cells.push_back(ratioText(ratio));
    }
    table.rows.push_back(std::move(cells));
  }
  if (table.rows.size() > 1) {
    table.rows.push_back({"geometric mean"});
    for (const Mean& mean : means)
      table.rows.back().push_back(mean.text());
  }
  return table;
}

std::vector<Table> speedUps(const std::vector<Summary>& summaries) {
  const auto buildsWith = [](const Summary& summary, bool isOne) {
    return summary.measure == kBuildSeconds && (summary.threadCount == 1) == isOne;
  };
  const auto one = std::find_if(summaries.begin(), summaries.end(),
                                [&](const Summary& summary) { return buildsWith(summary, true); });
  std::vector<Table> tables;
  if (one == summaries.end())
    return tables;
  for (const Summary& summary : summaries) {
    if (buildsWith(summary, false))
      tables.push_back(speedUp(*one, summary));
  }
  return tables;
}

/// The builds of the scenes of one family: by the number of triangles.
using Sizes = std::map<std::uint64_t, std::string>;

std::string nanosecondsText(double nanoseconds, double ratio) {
  return fmt::format("{} ({})", valueText(nanoseconds), ratioText(ratio));
}

Table scaling(const std::string& family, const Sizes& sizes, const Summary& summary) {
  Table table;
  table.title = fmt::format(
      "nanoseconds to build for each triangle of {}, and how many times the smallest scene's; {}",
      family, threadText(summary.threadCount));
  table.header = {"triangles", "log N"};
  for (const Summary::Column& column : summary.columns)
    table.header.push_back(nameOf(column));
  std::vector<std::optional<double>> smallest(summary.columns.size());
  for (const auto& [triangles, scene] : sizes) {
    const Summary::Row* const row = rowOf(summary, scene);
    if (row == nullptr)
      continue;
    const auto count = static_cast<double>(triangles);
    const double growth = std::log(count) / std::log(static_cast<double>(sizes.begin()->first));
    std::vector<std::string> cells = {std::to_string(triangles), ratioText(growth)};
    for (std::size_t i = 0; i < summary.columns.size(); ++i) {
      if (!row->values[i]) {
        cells.emplace_back(kNotMeasured);
        continue;
      }
      const double nanoseconds = *row->values[i] / count * 1e9;
      smallest[i] = smallest[i].value_or(nanoseconds);
      cells.push_back(nanosecondsText(nanoseconds, nanoseconds / *smallest[i]));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::vector<Table> scalings(const std::vector<Result>& results) {
  std::map<std::string, Sizes> families;
  std::vector<Result> builds;
  for (const Result& result : results) {
    const auto name = sizedSceneName(result.scene);
    if (!name || result.measure != kBuildSeconds)
      continue;
    families[name->family][result.objectCount > 0 ? result.objectCount : name->triangles] =
        result.scene;
    builds.push_back(result);
  }
  std::vector<Table> tables;
  for (const Summary& summary : summarise(builds)) {
    for (const auto& [family, sizes] : families)
      tables.push_back(scaling(family, sizes, summary));
  }
  return tables;
}

}  // namespace

std::vector<Table> comparisons(const std::vector<Result>& results) {
  const std::vector<Summary> summaries = summarise(results);
  std::vector<Table> tables = {presets(summaries)};
  for (auto& more : {speedUps(summaries), scalings(results)})
    tables.insert(tables.end(), more.begin(), more.end());
  std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
  return tables;
}

}  // namespace planetree::bench
