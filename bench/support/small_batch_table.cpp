#include "bench/support/small_batch_table.hpp"

#include "bench/support/mean.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace planetree::bench {

namespace {

// What a small batch may take more than its rays one by one: a call, and a part of the time of the
// rays. With that nobody has to ask whether rays are enough for a batch.
constexpr double kAllowedNanoseconds = 25.0;
constexpr double kAllowedPart = 0.05;

const Summary* summaryOf(const std::vector<Summary>& summaries, std::string_view measure) {
  const auto found = std::find_if(summaries.begin(), summaries.end(), [&](const Summary& summary) {
    return summary.measure == measure;
  });
  return found != summaries.end() ? &*found : nullptr;
}

/// The value of an engine in the same cell of another summary.
std::optional<double> valueIn(const Summary* other, const Summary::Column& column,
                              const Summary::Row& row) {
  if (other == nullptr)
    return std::nullopt;
  const auto place = columnOf(*other, column.engine, column.mode);
  const Summary::Row* const same = rowOf(*other, row.scene, row.kind);
  return place && same != nullptr ? same->values[*place] : std::nullopt;
}

/// The batches of one size, and how many of the cells seen so far are as they should be.
struct SizeColumn {
  std::size_t size = 1;
  const Summary* summary = nullptr;
  unsigned allowedCount = 0;
  unsigned count = 0;

  std::string addCell(std::optional<double> ofTheBatch, double ofOneRay) {
    if (!ofTheBatch)
      return kNotMeasured;
    const double oneByOne = ofOneRay * static_cast<double>(size);
    const double more = *ofTheBatch - oneByOne;
    const double allowed = kAllowedNanoseconds + kAllowedPart * oneByOne;
    allowedCount += more <= allowed ? 1u : 0u;
    ++count;
    return fmt::format("{:.1f} of {:.1f}", more, allowed);
  }
};

std::vector<SizeColumn> sizeColumns(const std::vector<Summary>& summaries) {
  std::vector<SizeColumn> columns;
  for (const std::size_t size : kSmallBatches)
    columns.push_back({.size = size, .summary = summaryOf(summaries, smallBatchMeasure(size))});
  return columns;
}

}  // namespace

Table smallBatchTable(const std::vector<Summary>& summaries) {
  Table table;
  table.title = fmt::format(
      "nanoseconds that small batches take more than their rays one by one, of {:.0f} + {:.0f} % "
      "that are allowed",
      kAllowedNanoseconds, 100.0 * kAllowedPart);
  const Summary* const single = summaryOf(summaries, kNanosecondsOneByOne);
  if (single == nullptr)
    return table;
  auto sizes = sizeColumns(summaries);
  table.header = {"scene, rays and mode", "one ray"};
  for (const SizeColumn& sized : sizes)
    table.header.push_back(fmt::format("batch of {}", sized.size));
  for (const Summary::Row& row : single->rows) {
    for (std::size_t i = 0; i < single->columns.size(); ++i) {
      if (!row.values[i])
        continue;
      const Summary::Column& column = single->columns[i];
      table.rows.push_back(
          {fmt::format("{} {} {}", row.scene, row.kind, column.mode), valueText(*row.values[i])});
      for (SizeColumn& sized : sizes) {
        table.rows.back().push_back(
            sized.addCell(valueIn(sized.summary, column, row), *row.values[i]));
      }
    }
  }
  table.rows.push_back({"as allowed", ""});
  for (const SizeColumn& sized : sizes)
    table.rows.back().push_back(fmt::format("{} of {}", sized.allowedCount, sized.count));
  return table;
}

std::vector<Result> withoutSmallBatches(std::vector<Result> results) {
  std::erase_if(results, [](const Result& result) { return isOfSmallBatches(result.measure); });
  return results;
}

}  // namespace planetree::bench
