#include "instruments/column_chart.hpp"

#include "talk.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace planetree::tool {

namespace {

constexpr double kMostSteps = 5.0;
constexpr double kLongestTick = 62.0;    // room for the numbers beside the axis
constexpr double kGapShare = 0.18;       // of a column's place
constexpr double kWidestColumn = 46.0;   // a tree of one level is no wall
constexpr double kCharacterWidth = 6.8;  // of the legend, on average

double heightOf(const ColumnChart::Column& column) {
  return std::accumulate(column.values.begin(), column.values.end(), 0.0);
}

double highestOf(const ColumnChart& chart) {
  double highest = 0.0;
  for (const ColumnChart::Column& column : chart.columns)
    highest = std::max(highest, heightOf(column));
  return highest;
}

std::string tickText(double tick) {
  const bool isWhole = tick == std::floor(tick) && tick < 1e15;
  return isWhole ? grouped(static_cast<std::uint64_t>(tick)) : fmt::format("{:.6g}", tick);
}

void addValueAxis(SvgText& svg, const PlotArea& area, const std::vector<double>& ticks) {
  for (const double tick : ticks) {
    const double y = area.bottom() - area.height * tick / ticks.back();
    svg.line(R"(<line class="{}" x1="{:.1f}" x2="{:.1f}" y1="{:.1f}" y2="{:.1f}"/>)",
             tick == 0.0 ? "axis" : "grid", area.left, area.left + area.width, y, y);
    svg.line(R"(<text class="soft" x="{:.1f}" y="{:.1f}" text-anchor="end">{}</text>)",
             area.left - 8.0, y + 4.0, tickText(tick));
  }
}

/// The chart's title, and behind it what its colours mean, right-aligned.
void addTitles(SvgText& svg, const ColumnChart& chart, const PlotArea& area) {
  svg.line(R"(<text class="ink head" x="{:.1f}" y="{:.1f}">{}</text>)", area.left, area.top - 18.0,
           xmlText(chart.title));
  svg.line(R"(<text class="soft" x="{:.1f}" y="{:.1f}" text-anchor="middle">{}</text>)",
           area.left + area.width / 2.0, area.bottom() + (chart.hasSlantedLabels ? 74.0 : 38.0),
           xmlText(chart.xTitle));
  svg.line(R"(<text class="soft" text-anchor="middle" transform="translate({:.1f} {:.1f}) )"
           R"svg(rotate(-90)">{}</text>)svg",
           area.left - kLongestTick, area.top + area.height / 2.0, xmlText(chart.yTitle));
  double x = area.left + area.width;
  for (auto series = chart.series.rbegin(); series != chart.series.rend(); ++series) {
    if (series->name.empty())
      continue;
    x -= kCharacterWidth * static_cast<double>(series->name.size());
    svg.line(R"(<text class="soft" x="{:.1f}" y="{:.1f}">{}</text>)", x, area.top - 18.0,
             xmlText(series->name));
    x -= 16.0;
    svg.line(R"(<rect class="{}" x="{:.1f}" y="{:.1f}" width="11" height="11"/>)",
             series->styleClass, x, area.top - 28.0);
    x -= 16.0;
  }
}

void addLabel(SvgText& svg, const ColumnChart& chart, const std::string& label, double x,
              double bottom) {
  if (label.empty())
    return;
  if (chart.hasSlantedLabels) {
    svg.line(R"(<text class="soft" text-anchor="end" transform="translate({:.1f} {:.1f}) )"
             R"svg(rotate(-45)">{}</text>)svg",
             x + 4.0, bottom + 14.0, xmlText(label));
    return;
  }
  svg.line(R"(<text class="soft" x="{:.1f}" y="{:.1f}" text-anchor="middle">{}</text>)", x,
           bottom + 17.0, xmlText(label));
}

void addColumn(SvgText& svg, const ColumnChart& chart, const ColumnChart::Column& column, double x,
               double width, double unit, double bottom) {
  svg.line("<g><title>{}</title>", xmlText(column.description));
  double y = bottom;
  for (std::size_t i = 0; i < column.values.size(); ++i) {
    const double height = column.values[i] * unit;
    if (!(height > 0.0))
      continue;
    y -= height;
    svg.line(R"(<rect class="{}" x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}"/>)",
             chart.series[i].styleClass, x, y, width, height);
  }
  svg.line("</g>");
}

}  // namespace

std::vector<double> axisTicks(double highest, bool wholeNumbers) {
  const double rough = highest > 0.0 ? highest / kMostSteps : 1.0 / kMostSteps;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= rough)
      step = factor * power;
  }
  if (wholeNumbers)
    step = std::max(step, 1.0);
  std::vector<double> ticks = {0.0, step};
  while (ticks.back() < highest)
    ticks.push_back(step * static_cast<double>(ticks.size()));
  return ticks;
}

void addChart(SvgText& svg, const ColumnChart& chart, const PlotArea& area) {
  const std::vector<double> ticks = axisTicks(highestOf(chart), chart.countsWholeThings);
  const double unit = area.height / ticks.back();
  const double place =
      area.width / static_cast<double>(std::max<std::size_t>(chart.columns.size(), 1));
  const double width = std::min(place * (1.0 - kGapShare), kWidestColumn);
  addTitles(svg, chart, area);
  addValueAxis(svg, area, ticks);
  for (std::size_t i = 0; i < chart.columns.size(); ++i) {
    const double middle = area.left + place * (static_cast<double>(i) + 0.5);
    addColumn(svg, chart, chart.columns[i], middle - width / 2.0, width, unit, area.bottom());
    addLabel(svg, chart, chart.columns[i].label, middle, area.bottom());
  }
}

}  // namespace planetree::tool
