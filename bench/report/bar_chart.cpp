#include "bench/report/bar_chart.hpp"

#include "bench/support/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

namespace planetree::bench {

namespace {

// Lengths in the units of the picture, which browsers take as pixels.
constexpr double kWidth = 760.0;
constexpr double kBarsLeft = 170.0;
constexpr double kLongestBar = 500.0;
constexpr double kBarHeight = 13.0;
constexpr double kGroupGap = 12.0;
constexpr double kHeaderHeight = 62.0;  ///< with one line of keys
constexpr double kKeysLeft = 14.0;
constexpr double kKeyHeight = 16.0;

/// Okabe and Ito, "Color universal design", 2008: told apart by everybody. The first is
/// planetree's.
constexpr std::array kColours = {"#d55e00", "#56b4e9", "#0072b2", "#009e73",
                                 "#cc79a7", "#e69f00", "#999999", "#000000"};

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

double longestOf(const BarChart::Group& group) {
  double longest = 0.0;
  for (const std::optional<double>& value : group.values)
    longest = std::max(longest, value.value_or(0.0));
  return longest;
}

double longestOf(const BarChart& chart) {
  double longest = 0.0;
  for (const BarChart::Group& group : chart.groups)
    longest = std::max(longest, longestOf(group));
  return longest;
}

double groupHeight(const BarChart& chart) {
  return kBarHeight * static_cast<double>(chart.series.size()) + kGroupGap;
}

const char* colourOf(std::size_t series) {
  return kColours[series % kColours.size()];
}

class SvgText {
 public:
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }
  void add(const SvgText& other) { text_ += other.text_; }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  std::string text_;
};

/// Adds the keys, in as many lines as they take; returns the height of all lines but the first.
double addLegend(SvgText& svg, const BarChart& chart) {
  double x = kKeysLeft;
  double y = 0.0;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const double width = 34.0 + 6.6 * static_cast<double>(chart.series[i].size());
    if (x > kKeysLeft && x + width > kWidth) {
      x = kKeysLeft;
      y += kKeyHeight;
    }
    svg.line(R"(<rect x="{:.0f}" y="{:.0f}" width="11" height="11" fill="{}"/>)", x, y + 36.0,
             colourOf(i));
    svg.line(R"(<text x="{:.0f}" y="{:.0f}">{}</text>)", x + 16.0, y + 46.0,
             escaped(chart.series[i]));
    x += width;
  }
  return y;
}

void addGroup(SvgText& svg, const BarChart& chart, const BarChart::Group& group, double top,
              double longest) {
  const double middle = top + (groupHeight(chart) - kGroupGap) / 2.0 + 4.0;
  svg.line(R"(<text x="{:.0f}" y="{:.0f}" text-anchor="end">{}</text>)", kBarsLeft - 10.0, middle,
           escaped(group.label));
  for (std::size_t i = 0; i < group.values.size(); ++i) {
    if (!group.values[i])
      continue;
    const double y = top + kBarHeight * static_cast<double>(i);
    const double bar = longest > 0.0 ? kLongestBar * *group.values[i] / longest : 0.0;
    svg.line(R"(<rect x="{:.0f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="{}"/>)", kBarsLeft,
             y, bar, kBarHeight - 1.0, colourOf(i));
    svg.line(R"(<text x="{:.1f}" y="{:.1f}" font-size="10">{}</text>)", kBarsLeft + bar + 5.0,
             y + kBarHeight - 3.5, valueText(*group.values[i]));
  }
}

}  // namespace

std::string toSvg(const BarChart& chart) {
  SvgText legend;
  const double headerHeight = kHeaderHeight + addLegend(legend, chart);
  const double height =
      headerHeight + groupHeight(chart) * static_cast<double>(chart.groups.size());
  SvgText svg;
  svg.line(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" )"
           R"(viewBox="0 0 {0:.0f} {1:.0f}" font-family="sans-serif" font-size="12" fill="#222">)",
           kWidth, height);
  svg.line(R"(<rect width="100%" height="100%" fill="#fff"/>)");
  svg.line(R"(<text x="14" y="22" font-size="15">{}</text>)", escaped(chart.title));
  svg.add(legend);
  const double longestOfAll = longestOf(chart);
  double top = headerHeight;
  for (const BarChart::Group& group : chart.groups) {
    addGroup(svg, chart, group, top, chart.scalesEachGroup ? longestOf(group) : longestOfAll);
    top += groupHeight(chart);
  }
  svg.line("</svg>");
  return svg.text();
}

}  // namespace planetree::bench
