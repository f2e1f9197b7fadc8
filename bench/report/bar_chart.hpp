#pragma once

#include <optional>
#include <string>
#include <vector>

namespace planetree::bench {

/// Horizontal bars in groups, as an SVG picture that reads alike on light and dark pages.
struct BarChart {
  struct Group {
    std::string label;
    std::vector<std::optional<double>> values;  ///< one for each series; nothing where unknown
  };

  std::string title;
  std::vector<std::string> series;
  std::vector<Group> groups;
  /// Whether the longest bar of each group is as long as that of any other, for values that differ
  /// by orders of magnitude between groups. The values stand beside the bars.
  bool scalesEachGroup = false;
};

/// The values must be finite and not negative.
[[nodiscard]] std::string toSvg(const BarChart& chart);

}  // namespace planetree::bench
