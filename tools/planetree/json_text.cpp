#include "json_text.hpp"

#include "option_values.hpp"
#include "output_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <span>
#include <string_view>

namespace planetree::tool {

namespace {

Json optionsJson(const BuildOptions& options) {
  const CostModel& cost = options.cost;
  return {
      {"leaf_size", options.leafSize},
      {"depth_limit", options.depthLimit ? Json(*options.depthLimit) : Json(nullptr)},
      {"traversal_cost", cost.traversalCost},
      {"intersection_cost", cost.intersectionCost},
      {"face_cost", cost.faceCost},
      {"empty_bonus", cost.emptyBonus},
      {"stops_by_cost", options.stopsByCost},
      {"allows_empty_cells", options.allowsEmptyCells},
      {"clips_references", options.clipsReferences},
      {"planar_rule", planarRuleName(options.planarRule)},
      {"exact_planes", options.exactPlanes},
      {"references_per_object", options.referencesPerObject},
      {"threads", options.threadCount},
  };
}

std::string_view sceneRangeName(SceneRange range) noexcept {
  switch (range) {
    case SceneRange::Within:
      return "within";
    case SceneRange::TooSmall:
      return "too-small";
    case SceneRange::TooLarge:
      return "too-large";
    case SceneRange::TooFar:
      return "too-far";
  }
  return "";
}

}  // namespace

Json meshJson(const MeshSize& size, const importing::ImportReport& report) {
  return {
      {"format", report.formatName},
      {"triangle_count", size.faceCount},
      {"vertex_count", size.vertexCount},
      {"polygon_count", report.polygonCount},
      {"skipped_polygon_count", report.skippedPolygonCount},
      {"unread_primitive_count", report.unreadPrimitiveCount},
      {"too_large_coordinate_count", report.tooLargeCount},
  };
}

Json buildJson(const BuildOptions& options, const BuildReport& report) {
  Json json = {
      {"object_count", report.objectCount},
      {"skipped_object_count", report.skippedCount},
      {"scene_range", sceneRangeName(report.sceneRange)},
  };
  for (const BuildPhase& phase : report.phases)
    json[fmt::format("{}_seconds", phase.name)] = phase.seconds;
  json["total_seconds"] = report.totalSeconds;
  json["peak_bytes"] = report.peakBytes;
  json["options"] = optionsJson(options);
  return json;
}

Json treeJson(const TreeStatistics& statistics) {
  return {
      {"split_node_count", statistics.splitNodeCount},
      {"leaf_node_count", statistics.leafNodeCount},
      {"empty_leaf_count", statistics.emptyLeafCount},
      {"reference_count", statistics.referenceCount},
      {"largest_leaf", statistics.largestLeaf},
      {"depth", statistics.depth},
      {"sah_cost", statistics.sahCost},
      {"bytes", statistics.bytes},
  };
}

std::string jsonText(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void printJson(const Json& json, bool isDataOnStandardOutput) {
  const std::string text = jsonText(json);
  if (isDataOnStandardOutput) {
    printToStandardError(text);
    return;
  }
  writeFile(kStandardOutput, std::as_bytes(std::span(text)));
}

}  // namespace planetree::tool
