#include "bench/support/comparisons.hpp"

#include "bench/scene/sized_scenes.hpp"
#include "bench/support/batch_tables.hpp"
#include "bench/support/mean.hpp"
#include "bench/support/picture_tables.hpp"
#include "bench/support/small_batch_table.hpp"
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

/// A preset, and what a user of Embree would build with for the same end.
struct Counterparts {
  std::string_view preset;
  std::string_view mode;
  std::string_view quality;
};
constexpr Counterparts kCounterparts[] = {{"fast", "fast-watertight", "medium"},
                                          {"balanced", "balanced-watertight", "high"},
                                          {"high", "high-watertight", "high"}};

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

/// All but batches, for which the best of Embree is the counterpart.
Table presets(const std::vector<Summary>& summaries) {
  Table table;
  table.title = "how many times better the presets are than their counterparts, geometric means";
  table.header = {"measure"};
  for (const Counterparts& pair : kCounterparts)
    table.header.push_back(fmt::format("{} / embree3 {}", pair.preset, pair.quality));
  for (const Summary& summary : summaries) {
    if (summary.measure == kBatchMraysPerSecond || isOfSmallBatches(summary.measure))
      continue;
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

/// How many times better a column of `several` is than the same of `one`, over the kinds of rays of
/// a scene.
Mean speedUpOf(const Summary& one, const Summary& several, std::size_t column,
               const std::string& scene) {
  Mean mean;
  const auto alone = columnOf(one, several.columns[column].engine, several.columns[column].mode);
  for (const Summary::Row& row : several.rows) {
    const Summary::Row* const before = rowOf(one, scene, row.kind);
    if (row.scene != scene || !alone || before == nullptr)
      continue;
    const auto& [a, b] = std::pair(before->values[*alone], row.values[column]);
    if (a && b)
      mean.add(moreIsBetter(one.measure) ? *b / *a : *a / *b);
  }
  return mean;
}

/// Two summaries of the same measure: with one thread, and with several.
Table speedUp(const Summary& one, const Summary& several) {
  Table table;
  table.title = fmt::format("how many times faster {} {} than 1", threadText(several.threadCount),
                            several.measure == kBatchMraysPerSecond ? "trace batches" : "build");
  table.header = {"scene"};
  for (const Summary::Column& column : several.columns)
    table.header.push_back(nameOf(column));
  std::vector<Mean> means(several.columns.size());
  for (const std::string& scene : namesOf(several, &Summary::Row::scene)) {
    std::vector<std::string> cells = {scene};
    bool isEmpty = true;
    for (std::size_t i = 0; i < several.columns.size(); ++i) {
      const Mean mean = speedUpOf(one, several, i, scene);
      cells.push_back(mean.text());
      if (mean.isEmpty())
        continue;
      isEmpty = false;
      means[i].add(mean.value());
    }
    if (!isEmpty)
      table.rows.push_back(std::move(cells));
  }
  if (table.rows.size() > 1) {
    table.rows.push_back({"geometric mean"});
    for (const Mean& mean : means)
      table.rows.back().push_back(mean.text());
    table.rows.push_back({"worst scene"});
    for (const Mean& mean : means)
      table.rows.back().push_back(mean.leastText());
  }
  return table;
}

std::vector<Table> speedUps(const std::vector<Summary>& summaries) {
  std::vector<Table> tables;
  for (const Summary& several : summaries) {
    if ((several.measure != kBuildSeconds && several.measure != kBatchMraysPerSecond) ||
        several.threadCount == 1)
      continue;
    const auto one = std::find_if(summaries.begin(), summaries.end(), [&](const Summary& summary) {
      return summary.measure == several.measure && summary.threadCount == 1;
    });
    if (one != summaries.end())
      tables.push_back(speedUp(*one, several));
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
    const Summary::Row* const row = rowOf(summary, scene, "");
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
  const std::vector<Summary> summaries = summarise(withoutPictures(results));
  std::vector<Table> tables = {presets(summaries), smallBatchTable(summaries)};
  for (auto& more :
       {batchTables(summaries), speedUps(summaries), scalings(results), pictureTables(results)})
    tables.insert(tables.end(), more.begin(), more.end());
  std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
  return tables;
}

}  // namespace planetree::bench
