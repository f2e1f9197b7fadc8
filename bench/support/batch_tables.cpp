#include "bench/support/batch_tables.hpp"

#include "bench/support/mean.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace planetree::bench {

namespace {

constexpr const char* kCoherentKind = "primary";

/// How far planetree is ahead in one cell, and whom it is compared with.
struct Lead {
  double ratio = 1.0;
  std::string mode;
};

/// Against the best of Embree, which is the one that planetree leads by least.
std::optional<Lead> leadOverEmbree(const Summary& summary, const std::string& scene,
                                   const std::string& kind) {
  const Summary::Row* const row = rowOf(summary, scene, kind);
  std::optional<Lead> lead;
  for (std::size_t i = 0; row != nullptr && i < summary.columns.size(); ++i) {
    if (summary.columns[i].engine != "embree3" || !row->ratios[i])
      continue;
    if (!lead || *row->ratios[i] < lead->ratio)
      lead = {*row->ratios[i], summary.columns[i].mode};
  }
  return lead;
}

/// The leads of all scenes.
struct LeadMeans {
  std::vector<Mean> ofKinds;
  Mean ofIncoherent;  ///< all but primary rays
};

/// A row of the table; empty if there is no lead.
std::vector<std::string> leadsOfScene(const Summary& summary, const std::string& scene,
                                      const std::vector<std::string>& kinds, LeadMeans& means) {
  std::vector<std::string> cells = {scene};
  Mean ofIncoherent;
  bool isEmpty = true;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const auto lead = leadOverEmbree(summary, scene, kinds[i]);
    if (!lead) {
      cells.emplace_back(kNotMeasured);
      continue;
    }
    isEmpty = false;
    cells.push_back(fmt::format("{} ({})", ratioText(lead->ratio), lead->mode));
    means.ofKinds[i].add(lead->ratio);
    if (kinds[i] == kCoherentKind)
      continue;
    ofIncoherent.add(lead->ratio);
    means.ofIncoherent.add(lead->ratio);
  }
  cells.push_back(ofIncoherent.text());
  return isEmpty ? std::vector<std::string>() : cells;
}

std::vector<std::string> lastRow(const char* label, const LeadMeans& means,
                                 std::string (Mean::*text)() const) {
  std::vector<std::string> cells = {label};
  for (const Mean& mean : means.ofKinds)
    cells.push_back((mean.*text)());
  cells.push_back((means.ofIncoherent.*text)());
  return cells;
}

Table leads(const Summary& summary) {
  const std::vector<std::string> kinds = namesOf(summary, &Summary::Row::kind);
  Table table;
  table.title = fmt::format(
      "how many times more rays planetree traces in batches than the best mode of embree3; {}",
      threadText(summary.threadCount));
  table.header = {"scene"};
  table.header.insert(table.header.end(), kinds.begin(), kinds.end());
  table.header.emplace_back("all but primary");
  LeadMeans means = {.ofKinds = std::vector<Mean>(kinds.size()), .ofIncoherent = {}};
  for (const std::string& scene : namesOf(summary, &Summary::Row::scene)) {
    auto row = leadsOfScene(summary, scene, kinds, means);
    if (!row.empty())
      table.rows.push_back(std::move(row));
  }
  if (!table.rows.empty()) {
    table.rows.push_back(lastRow("geometric mean", means, &Mean::text));
    table.rows.push_back(lastRow("worst", means, &Mean::leastText));
  }
  return table;
}

}  // namespace

std::vector<Table> batchTables(const std::vector<Summary>& summaries) {
  std::vector<Table> tables;
  for (const Summary& summary : summaries) {
    if (summary.measure == kBatchMraysPerSecond)
      tables.push_back(leads(summary));
  }
  return tables;
}

}  // namespace planetree::bench
