#pragma once

#include "instruments/svg_text.hpp"

#include <string>
#include <vector>

namespace planetree::tool {

/// A chart of columns as a part of an SVG picture. Each column stands on the axis and is made of
/// parts, one on top of the other. Colours come from the picture's style sheet, by class.
struct ColumnChart {
  /// One part of every column.
  struct Series {
    std::string name;        ///< for the legend; empty: not there
    std::string styleClass;  ///< of the style sheet
  };
  struct Column {
    std::string label;           ///< below the axis; may be empty
    std::string description;     ///< shown by viewers that point at it, and read out by others
    std::vector<double> values;  ///< one for each series; finite, not negative
  };

  std::string title;
  std::string xTitle;
  std::string yTitle;
  std::vector<Series> series;
  std::vector<Column> columns;
  bool hasSlantedLabels = false;   ///< for labels wider than their columns
  bool countsWholeThings = false;  ///< no ticks between whole numbers
};

/// Where the columns of a chart stand; titles and numbers are around it.
struct PlotArea {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;

  [[nodiscard]] double bottom() const noexcept { return top + height; }
};

void addChart(SvgText& svg, const ColumnChart& chart, const PlotArea& area);

/// The ends of equal steps from 0 to at least `highest`, each 1, 2 or 5 times a power of ten wide.
[[nodiscard]] std::vector<double> axisTicks(double highest, bool wholeNumbers);

}  // namespace planetree::tool
