#include "bench/support/summary.hpp"

#include "bench/support/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planetree::bench {

namespace {

/// The place of the first element with a property; it is appended if there is none.
template <class T, class Property>
std::size_t placeOf(std::vector<T>& all, const Property& property, T otherwise) {
  const auto found = std::find_if(all.begin(), all.end(), property);
  if (found != all.end())
    return static_cast<std::size_t>(found - all.begin());
  all.push_back(std::move(otherwise));
  return all.size() - 1;
}

Summary& summaryOf(std::vector<Summary>& summaries, const Result& result) {
  Summary fresh;
  fresh.measure = result.measure;
  fresh.threadCount = result.threadCount;
  const auto isSame = [&](const Summary& summary) {
    return summary.measure == result.measure && summary.threadCount == result.threadCount;
  };
  return summaries[placeOf(summaries, isSame, std::move(fresh))];
}

void place(const Result& result, Summary& summary) {
  const std::size_t column = placeOf(
      summary.columns,
      [&](const Summary::Column& other) {
        return other.engine == result.engine && other.mode == result.mode;
      },
      Summary::Column{result.engine, result.mode, result.isDefault});
  const std::size_t row = placeOf(
      summary.rows,
      [&](const Summary::Row& other) {
        return other.scene == result.scene && other.kind == result.kind;
      },
      Summary::Row{result.scene, result.kind, {}, {}});
  auto& values = summary.rows[row].values;
  values.resize(std::max(values.size(), column + 1));
  values[column] = result.value;
}

void findReference(Summary& summary) {
  for (std::size_t i = 0; i < summary.columns.size() && !summary.reference; ++i) {
    if (summary.columns[i].engine == "planetree" && summary.columns[i].isDefault)
      summary.reference = i;
  }
}

std::optional<double> ratioOf(const Summary& summary, const Summary::Row& row, std::size_t column) {
  if (!summary.reference || !row.values[*summary.reference] || !row.values[column])
    return std::nullopt;
  const double ours = *row.values[*summary.reference];
  const double theirs = *row.values[column];
  return moreIsBetter(summary.measure) ? ours / theirs : theirs / ours;
}

std::optional<double> geometricMean(const Summary& summary, std::size_t column) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const Summary::Row& row : summary.rows) {
    if (!row.ratios[column])
      continue;
    sum += std::log(*row.ratios[column]);
    ++count;
  }
  if (count == 0)
    return std::nullopt;
  return std::exp(sum / static_cast<double>(count));
}

void finish(Summary& summary) {
  findReference(summary);
  for (Summary::Row& row : summary.rows) {
    row.values.resize(summary.columns.size());
    for (std::size_t i = 0; i < summary.columns.size(); ++i)
      row.ratios.push_back(ratioOf(summary, row, i));
  }
  for (std::size_t i = 0; i < summary.columns.size(); ++i)
    summary.meanRatios.push_back(geometricMean(summary, i));
}

/// The value with this many digits that count, before and after the point together.
std::string withDigits(double value, int digits) {
  if (value == 0.0 || !std::isfinite(value))
    return fmt::format("{}", value);
  const int digitsBefore = static_cast<int>(std::floor(std::log10(std::fabs(value)))) + 1;
  return fmt::format("{:.{}f}", value, std::max(0, digits - digitsBefore));
}

std::string cellText(const Summary& summary, const Summary::Row& row, std::size_t column) {
  if (!row.values[column])
    return "-";
  const std::string value = valueText(*row.values[column]);
  if (!row.ratios[column] || column == summary.reference)
    return value;
  return fmt::format("{} {:>6}", value, ratioText(*row.ratios[column]));
}

}  // namespace

std::vector<Summary> summarise(const std::vector<Result>& results) {
  std::vector<Summary> summaries;
  for (const Result& result : results)
    place(result, summaryOf(summaries, result));
  for (Summary& summary : summaries)
    finish(summary);
  return summaries;
}

std::optional<std::size_t> columnOf(const Summary& summary, std::string_view engine,
                                    std::string_view mode) {
  for (std::size_t i = 0; i < summary.columns.size(); ++i) {
    if (summary.columns[i].engine == engine && summary.columns[i].mode == mode)
      return i;
  }
  return std::nullopt;
}

const Summary::Row* rowOf(const Summary& summary, std::string_view scene, std::string_view kind) {
  const auto found =
      std::find_if(summary.rows.begin(), summary.rows.end(),
                   [&](const Summary::Row& row) { return row.scene == scene && row.kind == kind; });
  return found != summary.rows.end() ? &*found : nullptr;
}

std::vector<std::string> namesOf(const Summary& summary, std::string Summary::Row::*part) {
  std::vector<std::string> names;
  for (const Summary::Row& row : summary.rows) {
    if (std::find(names.begin(), names.end(), row.*part) == names.end())
      names.push_back(row.*part);
  }
  return names;
}

std::string threadText(unsigned count) {
  return fmt::format("{} {}", count, count == 1 ? "thread" : "threads");
}

std::string measureTitle(const std::string& measure) {
  if (measure == kMraysPerSecond)
    return "million rays per second, more is better";
  if (measure == kBatchMraysPerSecond)
    return "million rays per second in batches, more is better";
  if (measure == kBuildSeconds)
    return "seconds to build, less is better";
  if (measure == kBytesPerTriangle)
    return "bytes per triangle, less is better";
  if (measure == kPeakBytesPerTriangle)
    return "most bytes per triangle held while building, less is better";
  if (measure == kNodeStepsPerRay)
    return "nodes visited per ray, less is better";
  if (measure == kBlockStepsPerRay)
    return "blocks tested per ray, less is better";
  return measure;
}

std::string valueText(double value) {
  return withDigits(value, 3);
}

std::string ratioText(double ratio) {
  return withDigits(ratio, 2) + "x";
}

std::string toText(const Summary& summary) {
  // Names above, cells below.
  std::vector<std::vector<std::string>> lines(2, {"", ""});
  for (const Summary::Column& column : summary.columns) {
    lines[0].push_back(column.engine);
    lines[1].push_back(column.mode + (column.isDefault ? "*" : ""));
  }
  for (const Summary::Row& row : summary.rows) {
    lines.push_back({row.scene, row.kind});
    for (std::size_t i = 0; i < summary.columns.size(); ++i)
      lines.back().push_back(cellText(summary, row, i));
  }
  if (summary.reference) {
    lines.push_back({"geometric mean", ""});
    for (const std::optional<double>& mean : summary.meanRatios)
      lines.back().push_back(mean ? ratioText(*mean) : "-");
  }

  return fmt::format("{}; {}\n", measureTitle(summary.measure), threadText(summary.threadCount)) +
         alignedLines(lines, 2);
}

}  // namespace planetree::bench
