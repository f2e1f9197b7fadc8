#include "talk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <vector>

namespace planetree::tool {

namespace {

/// A few skipped things: the first ones with their reasons, the others as a number.
void saySkippedList(const Talk& talk, std::string_view what, std::uint64_t count,
                    std::uint64_t outOf, const std::vector<std::string>& first) {
  constexpr std::size_t kShown = 3;
  const std::size_t shown = std::min(kShown, first.size());
  const auto end = first.begin() + static_cast<std::ptrdiff_t>(shown);
  const std::string rest = count > shown ? ", ..." : "";
  talk.say(fmt::format("  skipped {} of {} {}: {}{}", grouped(count), grouped(outOf), what,
                       fmt::join(first.begin(), end, ", "), rest));
}

void saySkippedPolygons(const Talk& talk, const MeshReadReport& report) {
  if (report.skippedPolygonCount == 0)
    return;
  std::vector<std::string> first;
  for (const SkippedPolygon& skipped : report.skipped) {
    first.push_back(fmt::format("face {} {}", skipped.polygon, skipped.reason));
  }
  saySkippedList(talk, "faces", report.skippedPolygonCount, report.polygonCount, first);
}

/// What the file has and the mesh has not.
void sayLeftOut(const Talk& talk, const importing::ImportReport& report) {
  saySkippedPolygons(talk, report);
  if (report.unreadPrimitiveCount != 0) {
    talk.say(fmt::format("  left out {}: points, lines and curves cannot be hit",
                         counted(report.unreadPrimitiveCount, "primitive")));
  }
  if (report.tooLargeCount != 0) {
    talk.say(fmt::format("  {} too large for the precision of the mesh, and infinite in it",
                         report.tooLargeCount == 1
                             ? "1 coordinate is"
                             : grouped(report.tooLargeCount) + " coordinates are"));
  }
  constexpr std::size_t kShownRemarks = 3;
  const std::size_t shown = std::min(kShownRemarks, report.remarks.size());
  for (std::size_t i = 0; i < shown; ++i)
    talk.say("  assimp: " + report.remarks[i]);
  if (report.remarkCount > shown)
    talk.say(fmt::format("  assimp: {}", counted(report.remarkCount - shown, "more remark")));
}

}  // namespace

void printToStandardError(std::string_view text) noexcept {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

std::string grouped(std::uint64_t number) {
  std::string digits = fmt::format("{}", number);
  for (std::size_t place = digits.size(); place > 3;) {
    place -= 3;
    digits.insert(place, 1, ',');
  }
  return digits;
}

std::string counted(std::uint64_t number, std::string_view word, std::string_view plural) {
  if (number == 1)
    return fmt::format("1 {}", word);
  return plural.empty() ? fmt::format("{} {}s", grouped(number), word)
                        : fmt::format("{} {}", grouped(number), plural);
}

std::string byteText(std::uint64_t bytes) {
  constexpr std::array kUnits = {"kB", "MB", "GB", "TB"};
  if (bytes < 1000)
    return fmt::format("{} bytes", bytes);
  double amount = static_cast<double>(bytes) / 1000.0;
  std::size_t unit = 0;
  for (; amount >= 1000.0 && unit + 1 < kUnits.size(); ++unit)
    amount /= 1000.0;
  return fmt::format("{:.1f} {}", amount, kUnits[unit]);
}

std::string_view reasonText(SkipReason reason) noexcept {
  switch (reason) {
    case SkipReason::IndexOutOfRange:
      return "has a vertex index beyond the last vertex";
    case SkipReason::NotFinite:
      return "has a coordinate that is NaN, infinite or beyond the range of float";
    case SkipReason::Empty:
      return "is empty";
    case SkipReason::RepeatedCorner:
      return "has two corners at one point";
  }
  return "cannot be hit";
}

std::string rangeText(SceneRange range) {
  // Limits are powers of two, and read as such.
  const auto power = [](float limit) { return fmt::format("2^{}", std::ilogb(limit)); };
  switch (range) {
    case SceneRange::Within:
      return {};
    case SceneRange::TooSmall:
      return fmt::format("is less than {} across", power(kSmallestExtent));
    case SceneRange::TooLarge:
      return fmt::format("is more than {} across", power(kLargestExtent));
    case SceneRange::TooFar:
      return fmt::format("has coordinates beyond {}", power(kLargestCoordinate));
  }
  return {};
}

void sayMesh(const Talk& talk, const std::string& name, const MeshSize& size,
             const importing::ImportReport& report, double seconds) {
  talk.say(
      fmt::format("{}: {}, {} ({}, read in {:.2f} s)", name, counted(size.faceCount, "triangle"),
                  counted(size.vertexCount, "vertex", "vertices"), report.formatName, seconds));
  sayLeftOut(talk, report);
}

void sayRange(const Talk& talk, const BuildReport& report) {
  if (report.sceneRange != SceneRange::Within) {
    talk.say(fmt::format("  the scene {}: hits may be lost; scale it by a power of two, or move it",
                         rangeText(report.sceneRange)));
  }
}

void saySkipped(const Talk& talk, const BuildReport& report,
                std::span<const std::uint32_t> sourceFaces) {
  if (report.skippedCount == 0)
    return;
  std::vector<std::string> first;
  for (const SkippedObject& skipped : report.skipped) {
    const std::uint32_t face =
        sourceFaces.empty() ? skipped.primitive : sourceFaces[skipped.primitive];
    first.push_back(fmt::format("face {} {}", face, reasonText(skipped.reason)));
  }
  saySkippedList(talk, "triangles", report.skippedCount, report.objectCount, first);
}

void sayTree(const Talk& talk, const BuildReport& report, const TreeStatistics& statistics,
             std::string_view object) {
  const std::uint64_t objectCount = report.objectCount - report.skippedCount;
  const double references = static_cast<double>(statistics.referenceCount) /
                            static_cast<double>(std::max<std::uint64_t>(objectCount, 1));
  talk.say(fmt::format("tree of {}, built in {:.2f} s", counted(objectCount, object),
                       report.totalSeconds));
  talk.say(fmt::format("  {}, {} ({} empty), depth {}",
                       counted(statistics.splitNodeCount, "split node"),
                       counted(statistics.leafNodeCount, "leaf", "leaves"),
                       grouped(statistics.emptyLeafCount), statistics.depth));
  talk.say(fmt::format("  {:.2f} references per object, largest leaf {}, SAH cost {:.1f}, {}",
                       references, grouped(statistics.largestLeaf), statistics.sahCost,
                       byteText(statistics.bytes)));
}

void sayRendering(const Talk& talk, render::RenderMode mode, const render::Rendering& rendering) {
  const double seconds = std::max(rendering.seconds, 1e-9);
  const auto rays = static_cast<double>(rendering.rayCount);
  talk.say(fmt::format("traced {} rays in {:.2f} s: {:.2f} million rays per second",
                       grouped(rendering.rayCount), rendering.seconds, rays / seconds / 1e6));
  if (!rendering.range)
    return;
  const render::ValueRange& range = *rendering.range;
  if (mode == render::RenderMode::Heat) {
    talk.say(
        fmt::format("heat: black is {:.0f}, pale yellow {:.0f} split nodes visited and "
                    "objects tested per ray; the most is {:.0f}",
                    range.darkest, range.brightest, range.highest));
  } else {
    talk.say(fmt::format("depth: white is {:.6g}, the darkest grey {:.6g} from the eye",
                         range.brightest, range.darkest));
  }
}

}  // namespace planetree::tool
