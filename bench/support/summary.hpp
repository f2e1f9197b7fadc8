#pragma once

#include "bench/support/result.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planetree::bench {

/// The results of one measure with one number of threads, as a table: a row for each scene and kind
/// of rays, a column for each engine in each mode.
struct Summary {
  struct Column {
    std::string engine;
    std::string mode;
    bool isDefault = false;
  };
  struct Row {
    std::string scene;
    std::string kind;
    std::vector<std::optional<double>> values;  ///< one for each column; nothing where not measured
    std::vector<std::optional<double>> ratios;  ///< likewise
  };

  std::string measure;
  unsigned threadCount = 1;
  std::vector<Column> columns;
  /// The column that the ratios compare with: planetree's default, if it took part.
  std::optional<std::size_t> reference;
  std::vector<Row> rows;
  /// The geometric mean of each column's ratios, over the rows that have one.
  std::vector<std::optional<double>> meanRatios;
};

/// One summary for each measure and number of threads, in the order in which they first occur. A
/// ratio says how many times better planetree's default is than the column: above 1 it leads,
/// whether more is better or less.
[[nodiscard]] std::vector<Summary> summarise(const std::vector<Result>& results);

/// The column of an engine in a mode.
[[nodiscard]] std::optional<std::size_t> columnOf(const Summary& summary, std::string_view engine,
                                                  std::string_view mode);
/// The row of a scene and a kind of rays, or null.
[[nodiscard]] const Summary::Row* rowOf(const Summary& summary, std::string_view scene,
                                        std::string_view kind);
/// The scenes, or the kinds, of all rows: each once, in the order in which they first occur.
[[nodiscard]] std::vector<std::string> namesOf(const Summary& summary,
                                               std::string Summary::Row::*part);

/// "1 thread", "2 threads"
[[nodiscard]] std::string threadText(unsigned count);

/// "million rays per second, more is better"
[[nodiscard]] std::string measureTitle(const std::string& measure);

/// Three digits that count: 0.0123, 4.56, 78.9, 1230.
[[nodiscard]] std::string valueText(double value);
/// Two, since the next one is noise: 0.31x, 4.5x, 12x.
[[nodiscard]] std::string ratioText(double ratio);

/// The table in plain text, to be read in a terminal.
[[nodiscard]] std::string toText(const Summary& summary);

}  // namespace planetree::bench
