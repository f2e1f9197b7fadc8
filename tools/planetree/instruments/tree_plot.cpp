#include "instruments/tree_plot.hpp"

#include "instruments/column_chart.hpp"
#include "instruments/leaf_size_bins.hpp"
#include "instruments/svg_text.hpp"
#include "instruments/text_bar.hpp"
#include "talk.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace planetree::tool {

namespace {

// Lengths in the units of the picture, which browsers take as pixels.
constexpr double kWidth = 1000.0;
constexpr double kHeight = 640.0;
constexpr PlotArea kLeavesArea = {.left = 106.0, .top = 138.0, .width = 480.0, .height = 166.0};
constexpr PlotArea kCostArea = {.left = 106.0, .top = 408.0, .width = 480.0, .height = 166.0};
constexpr PlotArea kSizesArea = {.left = 700.0, .top = 138.0, .width = 270.0, .height = 436.0};
constexpr double kSlantedLabelHeight = 36.0;
constexpr std::size_t kMostLabels = 16;
constexpr std::size_t kLongestName = 60;

// Okabe and Ito, "Color universal design", 2008: told apart by everybody.
constexpr const char* kStyle = R"(<style>
  text { font: 12px system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif }
  .name { font-size: 20px; font-weight: 600 }
  .head { font-size: 14px; font-weight: 600 }
  .paper { fill: #ffffff }
  .ink { fill: #1d2126 }
  .soft { fill: #5b636e }
  .grid { stroke: #e3e6ea }
  .axis { stroke: #8b929c }
  .blue { fill: #0072b2 }
  .orange { fill: #e69f00 }
  .green { fill: #009e73 }
  @media (prefers-color-scheme: dark) {
    .paper { fill: #14171b }
    .ink { fill: #eef0f3 }
    .soft { fill: #a3abb6 }
    .grid { stroke: #2a2f36 }
    .axis { stroke: #6b737e }
    .blue { fill: #56b4e9 }
    .green { fill: #2cbf94 }
  }
</style>)";

/// Every so many columns have a label, so that not too many have one.
std::size_t labelStep(std::size_t columnCount) {
  for (const std::size_t step : {std::size_t{1}, std::size_t{5}}) {
    if (columnCount <= step * kMostLabels)
      return step;
  }
  return 10;
}

/// Short also for the largest of leaves.
std::string sizeLabel(const LeafSizeBin& bin) {
  return bin.lowest < 1000 ? sizeText(bin) : fmt::format("from {}", grouped(bin.lowest));
}

std::string levelLabel(std::size_t level, std::size_t levelCount) {
  return level == 1 || level % labelStep(levelCount) == 0 ? fmt::format("{}", level) : "";
}

ColumnChart leavesByLevel(const TreeStatistics& tree) {
  ColumnChart chart{.title = "Leaves by level",
                    .xTitle = "level (the root is level 1)",
                    .yTitle = "leaves",
                    .series = {{"with triangles", "blue"}, {"empty", "orange"}},
                    .columns = {},
                    .countsWholeThings = true};
  for (std::size_t i = 0; i < tree.levels.size(); ++i) {
    const LevelStatistics& level = tree.levels[i];
    const auto emptyCount = static_cast<double>(level.emptyLeafCount);
    chart.columns.push_back(
        {.label = levelLabel(i + 1, tree.levels.size()),
         .description = fmt::format("Level {}: {}, {} of them empty", i + 1,
                                    counted(level.leafNodeCount, "leaf", "leaves"),
                                    grouped(level.emptyLeafCount)),
         .values = {static_cast<double>(level.leafNodeCount) - emptyCount, emptyCount}});
  }
  return chart;
}

ColumnChart costByLevel(const TreeStatistics& tree) {
  ColumnChart chart{.title = "SAH cost by level",
                    .xTitle = "level (the root is level 1)",
                    .yTitle = "cost of a ray",
                    .series = {{"testing triangles", "blue"}, {"passing splits", "green"}},
                    .columns = {}};
  for (std::size_t i = 0; i < tree.levels.size(); ++i) {
    const LevelStatistics& level = tree.levels[i];
    chart.columns.push_back(
        {.label = levelLabel(i + 1, tree.levels.size()),
         .description = fmt::format("Level {}: {:.3g} for triangles, {:.3g} for splits", i + 1,
                                    level.intersectionCost, level.traversalCost),
         .values = {level.intersectionCost, level.traversalCost}});
  }
  return chart;
}

ColumnChart leavesBySize(const TreeStatistics& tree) {
  ColumnChart chart{.title = "Leaves by size",
                    .xTitle = "triangles in the leaf",
                    .yTitle = "leaves",
                    .series = {{"", "blue"}, {"", "orange"}},
                    .columns = {},
                    .countsWholeThings = true};
  const std::vector<LeafSizeBin> bins = leafSizeBins(tree.leafSizes);
  chart.hasSlantedLabels =
      std::any_of(bins.begin(), bins.end(), [](const LeafSizeBin& bin) { return bin.isRange(); });
  // Slanted labels are as wide as a line is high.
  const std::size_t step =
      chart.hasSlantedLabels ? 1 + bins.size() / (kMostLabels + 1) : labelStep(bins.size());
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const auto leafCount = static_cast<double>(bins[i].leafCount);
    const bool isEmpty = bins[i].highest == 0;
    chart.columns.push_back(
        {.label = i % step == 0 ? sizeLabel(bins[i]) : "",
         .description = fmt::format(
             "{} of {} triangles", counted(bins[i].leafCount, "leaf", "leaves"), sizeText(bins[i])),
         .values = {isEmpty ? 0.0 : leafCount, isEmpty ? leafCount : 0.0}});
  }
  return chart;
}

std::string summary(const TreeAccount& account) {
  const TreeStatistics& tree = account.tree;
  return fmt::format(
      "{} · {} · {}, {} of them empty · {:.2f} references for each triangle · SAH cost {:.1f}",
      counted(account.objectCount(), "triangle"), counted(tree.depth, "level"),
      counted(tree.leafNodeCount, "leaf", "leaves"), grouped(tree.emptyLeafCount),
      account.perObject(tree.referenceCount), tree.sahCost);
}

/// The level that has most of something, counted from 1.
template <class ValueOf>
std::size_t peakLevel(const TreeStatistics& tree, const ValueOf& valueOf) {
  const auto peak = std::max_element(
      tree.levels.begin(), tree.levels.end(),
      [&](const LevelStatistics& a, const LevelStatistics& b) { return valueOf(a) < valueOf(b); });
  return static_cast<std::size_t>(peak - tree.levels.begin()) + 1;
}

std::string description(const TreeAccount& account) {
  const std::size_t leafPeak =
      peakLevel(account.tree, [](const LevelStatistics& level) { return level.leafNodeCount; });
  const std::size_t costPeak = peakLevel(account.tree, [](const LevelStatistics& level) {
    return level.traversalCost + level.intersectionCost;
  });
  return fmt::format(
      "Three charts of a kd-tree. {}. Leaves by level: most are on level {}. Cost by the surface "
      "area heuristic by level: highest on level {}. Leaves by size: {:.2f} triangles on average "
      "where there are any, {} at most.",
      summary(account), leafPeak, costPeak, account.meanLeafSize(),
      grouped(account.tree.largestLeaf));
}

}  // namespace

std::string treePlot(const TreeAccount& account) {
  const std::string name = std::filesystem::path(account.model).filename().string();
  SvgText svg;
  svg.line(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" )"
           R"(viewBox="0 0 {0:.0f} {1:.0f}" role="img" aria-labelledby="title description">)",
           kWidth, kHeight);
  svg.line(R"(<title id="title">The kd-tree of {}</title>)", xmlText(name));
  svg.line(R"(<desc id="description">{}</desc>)", xmlText(description(account)));
  svg.line("{}", kStyle);
  svg.line(R"(<rect class="paper" width="{:.0f}" height="{:.0f}"/>)", kWidth, kHeight);
  svg.line(R"(<text class="ink name" x="34" y="44">The kd-tree of {}</text>)",
           xmlText(shortened(name, kLongestName)));
  svg.line(R"(<text class="soft" x="34" y="68">{}</text>)", xmlText(summary(account)));
  addChart(svg, leavesByLevel(account.tree), kLeavesArea);
  addChart(svg, costByLevel(account.tree), kCostArea);
  const ColumnChart sizes = leavesBySize(account.tree);
  PlotArea sizesArea = kSizesArea;
  if (sizes.hasSlantedLabels)
    sizesArea.height -= kSlantedLabelHeight;
  addChart(svg, sizes, sizesArea);
  svg.line("</svg>");
  return svg.take();
}

}  // namespace planetree::tool
