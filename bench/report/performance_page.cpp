#include "bench/report/performance_page.hpp"

#include "bench/report/bar_chart.hpp"
#include "bench/scene/sized_scenes.hpp"
#include "bench/support/comparisons.hpp"
#include "bench/support/picture_tables.hpp"
#include "bench/support/small_batch_table.hpp"
#include "bench/support/summary.hpp"
#include "bench/support/table.hpp"

#include <planetree/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace planetree::bench {

namespace {

constexpr std::string_view kBegin = "<!-- figures: begin -->";
constexpr std::string_view kEnd = "<!-- figures: end -->";

std::string cell(const Summary& summary, const Summary::Row& row, std::size_t column) {
  if (!row.values[column])
    return "";
  const std::string value = valueText(*row.values[column]);
  if (column == summary.reference)
    return "**" + value + "**";
  return row.ratios[column] ? fmt::format("{} ({})", value, ratioText(*row.ratios[column])) : value;
}

std::string markdownTable(const Summary& summary) {
  const bool hasKinds = std::any_of(summary.rows.begin(), summary.rows.end(),
                                    [](const Summary::Row& row) { return !row.kind.empty(); });
  std::string table = hasKinds ? "| scene | rays |" : "| scene |";
  std::string rule = hasKinds ? "| --- | --- |" : "| --- |";
  for (const Summary::Column& column : summary.columns) {
    table += fmt::format(" {} {}{} |", column.engine, column.mode, column.isDefault ? " \\*" : "");
    rule += " ---: |";
  }
  table += "\n" + rule + "\n";
  for (const Summary::Row& row : summary.rows) {
    table += fmt::format("| {} |", escapedForCell(row.scene));
    if (hasKinds)
      table += fmt::format(" {} |", row.kind);
    for (std::size_t i = 0; i < summary.columns.size(); ++i)
      table += fmt::format(" {} |", cell(summary, row, i));
    table += "\n";
  }
  if (summary.reference) {
    table += hasKinds ? "| geometric mean | |" : "| geometric mean |";
    for (const std::optional<double>& mean : summary.meanRatios)
      table += mean ? fmt::format(" {} |", ratioText(*mean)) : " |";
    table += "\n";
  }
  return table;
}

/// Columns that are one bar of a chart: the best of them is shown.
struct Series {
  std::string name;
  std::vector<std::size_t> columns;
};

/// What follows the quality in a rival's mode: "-robust" of "high-robust".
std::string variantOf(const std::string& mode) {
  const std::size_t dash = mode.find('-');
  return dash == std::string::npos ? "" : mode.substr(dash);
}

/// For rays, a rival is shown with whatever quality of build is best for it, once for each variant;
/// for build and memory, where that would always be the lowest, with each quality.
std::vector<Series> seriesOf(const Summary& summary) {
  const bool isRays = moreIsBetter(summary.measure);
  std::vector<Series> all;
  for (std::size_t i = 0; i < summary.columns.size(); ++i) {
    const auto& [engine, mode, isDefault] = summary.columns[i];
    const bool isRival = engine != "planetree" && engine != "cgal";
    if (isRival && !isRays && !variantOf(mode).empty())
      continue;
    const std::string name =
        isRival && isRays ? engine + variantOf(mode) + ", best" : engine + " " + mode;
    const auto known = std::find_if(all.begin(), all.end(),
                                    [&](const Series& series) { return series.name == name; });
    if (known != all.end())
      known->columns.push_back(i);
    else
      all.push_back({name, {i}});
  }
  return all;
}

std::optional<double> bestValue(const Summary& summary, const Summary::Row& row,
                                const Series& series) {
  std::optional<double> best;
  for (const std::size_t column : series.columns) {
    const std::optional<double>& value = row.values[column];
    if (value && (!best || (moreIsBetter(summary.measure) ? *value > *best : *value < *best)))
      best = value;
  }
  return best;
}

/// "mrays_per_second-ao-1.svg": measure, kind and threads.
Plot plotOf(const Summary& summary, const std::string& kind) {
  const std::vector<Series> series = seriesOf(summary);
  BarChart chart;
  chart.title = (kind.empty() ? "" : kind + " rays: ") + measureTitle(summary.measure);
  chart.scalesEachGroup = summary.measure == kBuildSeconds;
  for (const Series& one : series)
    chart.series.push_back(one.name);
  for (const Summary::Row& row : summary.rows) {
    if (row.kind != kind)
      continue;
    BarChart::Group group{row.scene, {}};
    for (const Series& one : series)
      group.values.push_back(bestValue(summary, row, one));
    chart.groups.push_back(std::move(group));
  }
  const std::string name = fmt::format("{}{}{}-{}.svg", summary.measure, kind.empty() ? "" : "-",
                                       kind, summary.threadCount);
  return {name, chart.title, toSvg(chart)};
}

std::string asHeading(std::string title) {
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

std::string sectionTitle(const Summary& summary) {
  return fmt::format("{} ({})", asHeading(measureTitle(summary.measure)),
                     threadText(summary.threadCount));
}

/// Steps are few numbers that say little in a picture.
bool isPlotted(const Summary& summary) {
  return summary.measure != kNodeStepsPerRay && summary.measure != kBlockStepsPerRay;
}

/// All but the builds that have a table of their own, which shows how they grow with the scene.
std::vector<Result> withoutSizedBuilds(std::vector<Result> results) {
  std::erase_if(results, [](const Result& result) {
    return result.measure == kBuildSeconds && sizedSceneName(result.scene);
  });
  return results;
}

/// "a", or "a; b" if the results were not all made by one.
std::string joined(const std::vector<Result>& results, std::string Result::*part) {
  std::set<std::string> all;
  for (const Result& result : results)
    all.insert(result.*part);
  return fmt::format("{}", fmt::join(all, "; "));
}

}  // namespace

PerformanceFigures performanceFigures(const std::vector<Result>& results,
                                      const std::string& machine, const std::string& plotFolder) {
  PerformanceFigures figures;
  figures.markdown =
      fmt::format("Machine: {}. Compiler: {}. Commit: {}.\n", machine,
                  joined(results, &Result::compiler), joined(results, &Result::commit));
  for (const Summary& summary :
       summarise(withoutPictures(withoutSmallBatches(withoutSizedBuilds(results))))) {
    figures.markdown +=
        fmt::format("\n### {}\n\n{}", sectionTitle(summary), markdownTable(summary));
    if (!isPlotted(summary))
      continue;
    figures.markdown += "\n";
    for (const std::string& kind : namesOf(summary, &Summary::Row::kind)) {
      Plot plot = plotOf(summary, kind);
      figures.markdown += fmt::format("![{}]({}/{})\n", plot.title, plotFolder, plot.name);
      figures.plots.push_back(std::move(plot));
    }
  }
  for (const Table& table : comparisons(results))
    figures.markdown += fmt::format("\n### {}\n\n{}", asHeading(table.title), toMarkdown(table));
  return figures;
}

std::string withFigures(const std::string& page, const std::string& figures,
                        const std::string& file) {
  const std::size_t begin = page.find(kBegin);
  const std::size_t end = page.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos || end < begin) {
    throw Error(ErrorCode::MalformedFile, "the page has no place for figures",
                fmt::format("Add the lines {} and {} where they are to stand.", kBegin, kEnd),
                {.file = file});
  }
  const std::string before = page.substr(0, begin + kBegin.size());
  return before + "\n\n" + figures + "\n" + page.substr(end);
}

}  // namespace planetree::bench
