#include "instruments/tree_page.hpp"

#include "instruments/leaf_size_bins.hpp"
#include "instruments/text_bar.hpp"
#include "talk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace planetree::tool {

namespace {

constexpr std::size_t kBarWidth = 24;
constexpr std::size_t kShownSkips = 5;

class Page {
 public:
  void title(std::string_view text) { fmt::format_to(std::back_inserter(text_), "{}\n", text); }
  void heading(std::string_view text) { fmt::format_to(std::back_inserter(text_), "\n{}\n", text); }
  /// One number, with words behind it.
  void row(std::string_view name, std::string_view value, std::string_view words = {}) {
    line(fmt::format("  {:<16}{:>14}   {}", name, value, words));
  }
  void line(std::string text) {
    text.erase(text.find_last_not_of(' ') + 1);
    text_ += text + '\n';
  }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string percent(std::uint64_t part, std::uint64_t whole) {
  const double share = whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
  return fmt::format("{:.1f} %", 100.0 * share);
}

std::string pointText(const Vec3f& point) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", point.x, point.y, point.z);
}

/// What was skipped: how many, out of how many, and the first ones with their reasons.
void addSkipped(Page& page, std::string_view name, std::uint64_t count, std::string_view outOf,
                const std::vector<std::string>& first) {
  if (count == 0)
    return;
  page.row(name, grouped(count), outOf);
  const std::size_t shownCount = std::min(first.size(), kShownSkips);
  for (std::size_t i = 0; i < shownCount; ++i)
    page.line("    " + first[i]);
  if (count > shownCount)
    page.line(fmt::format("    ... and {} more", grouped(count - shownCount)));
}

void addModel(Page& page, const TreeAccount& account) {
  page.heading("Model");
  page.row("triangles", grouped(account.triangleCount));
  addSkipped(page, "skipped faces", account.skippedPolygonCount,
             fmt::format("of {} in the file", grouped(account.polygonCount)),
             account.skippedPolygons);
  addSkipped(page, "skipped", account.build.skippedCount, "not in the tree: no ray can hit them",
             account.skippedTriangles);
  if (account.build.sceneRange != SceneRange::Within)
    page.line("  the scene " + rangeText(account.build.sceneRange) + ": hits may be lost");
  if (account.unreadPrimitiveCount > 0) {
    page.row("not read", grouped(account.unreadPrimitiveCount),
             "points, lines and curves, which cannot be hit");
  }
  page.row("vertices", grouped(account.vertexCount));
  if (account.tooLargeCount > 0)
    page.row("too large", grouped(account.tooLargeCount), "coordinates, infinite as float");
  page.line("  bounds    " + pointText(account.bounds.lower) + " to " +
            pointText(account.bounds.upper));
  page.line("  size      " + pointText(account.bounds.size()));
  for (const std::string& remark : account.remarks)
    page.line("  remark    " + remark);
}

void addTree(Page& page, const TreeAccount& account) {
  const TreeStatistics& tree = account.tree;
  double splitCost = 0.0;
  for (const LevelStatistics& level : tree.levels)
    splitCost += level.traversalCost;

  page.heading("Tree");
  page.row("levels", fmt::format("{}", tree.depth));
  page.row("split nodes", grouped(tree.splitNodeCount));
  page.row("leaves", grouped(tree.leafNodeCount));
  page.row("  empty", grouped(tree.emptyLeafCount),
           percent(tree.emptyLeafCount, tree.leafNodeCount));
  page.row("  mean size", fmt::format("{:.2f}", account.meanLeafSize()),
           "triangles, without the empty ones");
  page.row("  largest", grouped(tree.largestLeaf), "triangles");
  page.row("references", grouped(tree.referenceCount),
           fmt::format("{:.2f} for each triangle", account.perObject(tree.referenceCount)));
  page.row("SAH cost", fmt::format("{:.2f}", tree.sahCost),
           fmt::format("{:.2f} for splits, {:.2f} for triangles; expected of a ray", splitCost,
                       tree.sahCost - splitCost));
  page.row("memory", byteText(tree.bytes),
           fmt::format("{:.1f} bytes for each triangle, without the mesh",
                       account.perObject(tree.bytes)));
  page.row("  to build", byteText(account.build.peakBytes),
           fmt::format("{:.1f} bytes for each triangle, at the most",
                       account.perObject(account.build.peakBytes)));
}

void addQueries(Page& page, const TreeAccount& account) {
  page.heading("Queries");
  page.row("instruction set", account.instructionSet,
           fmt::format("the best one first, the machine has {}",
                       fmt::join(account.supportedInstructionSets, ", ")));
}

void addTimes(Page& page, const TreeAccount& account) {
  const auto seconds = [](double time) { return fmt::format("{:.4f} s", time); };
  page.heading("Time");
  page.row("read", seconds(account.readSeconds));
  for (const BuildPhase& phase : account.build.phases)
    page.row(phase.name, seconds(phase.seconds));
  page.row("all", seconds(account.readSeconds + account.build.totalSeconds));
}

void addLevels(Page& page, const TreeStatistics& tree) {
  double mostLeaves = 0.0;
  double highestCost = 0.0;
  const auto costOf = [](const LevelStatistics& level) {
    return level.traversalCost + level.intersectionCost;
  };
  for (const LevelStatistics& level : tree.levels) {
    mostLeaves = std::max(mostLeaves, static_cast<double>(level.leafNodeCount));
    highestCost = std::max(highestCost, costOf(level));
  }
  page.heading("Levels");
  page.line(fmt::format("  {:>5} {:>11} {:>11} {:<{}}{:>9}", "level", "splits", "leaves", "",
                        kBarWidth + 1, "SAH cost"));
  for (std::size_t i = 0; i < tree.levels.size(); ++i) {
    const LevelStatistics& level = tree.levels[i];
    const auto leafCount = static_cast<double>(level.leafNodeCount);
    page.line(fmt::format("  {:>5} {:>11} {:>11} {} {:>8.3f} {}", i + 1,
                          grouped(level.splitNodeCount), grouped(level.leafNodeCount),
                          padded(textBar(leafCount, mostLeaves, kBarWidth), kBarWidth),
                          costOf(level), textBar(costOf(level), highestCost, kBarWidth)));
  }
}

void addLeafSizes(Page& page, const TreeStatistics& tree) {
  const std::vector<LeafSizeBin> bins = leafSizeBins(tree.leafSizes);
  double mostLeaves = 0.0;
  std::size_t width = std::string_view("triangles").size();
  for (const LeafSizeBin& bin : bins) {
    mostLeaves = std::max(mostLeaves, static_cast<double>(bin.leafCount));
    width = std::max(width, columnCount(sizeText(bin)));
  }
  page.heading("Leaf sizes");
  page.line(fmt::format("  {} {:>11}", paddedLeft("triangles", width), "leaves"));
  for (const LeafSizeBin& bin : bins) {
    page.line(fmt::format("  {} {:>11} {}", paddedLeft(sizeText(bin), width),
                          grouped(bin.leafCount),
                          textBar(static_cast<double>(bin.leafCount), mostLeaves, 2 * kBarWidth)));
  }
}

}  // namespace

std::string treePage(const TreeAccount& account) {
  Page page;
  page.title(fmt::format("{} ({})", account.model, account.format));
  addModel(page, account);
  addTree(page, account);
  addQueries(page, account);
  addTimes(page, account);
  addLevels(page, account.tree);
  addLeafSizes(page, account.tree);
  return page.take();
}

}  // namespace planetree::tool
