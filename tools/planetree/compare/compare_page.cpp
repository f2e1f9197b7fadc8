#include "compare/compare_page.hpp"

#include "talk.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <string_view>

namespace planetree::tool {

namespace {

constexpr std::size_t kNameWidth = 26;
constexpr std::size_t kColumnWidth = 13;

double perRay(std::uint64_t count, const ComparedModel& model) {
  return static_cast<double>(count) /
         static_cast<double>(std::max<std::uint64_t>(model.primaryRayCount, 1));
}

/// Four digits, or more before the point.
std::string numberText(double number) {
  const int digits = number >= 1000.0 ? 0 : number >= 100.0 ? 1 : number >= 10.0 ? 2 : 3;
  return fmt::format("{:.{}f}", number, digits);
}

std::string secondsText(double seconds) {
  return seconds < 1.0 ? fmt::format("{} ms", numberText(1000.0 * seconds))
                       : fmt::format("{} s", numberText(seconds));
}

}  // namespace

std::string comparePage(const ComparedModel& model, const std::vector<PresetFigures>& figures) {
  std::string page =
      fmt::format("{} ({})\n", model.name, counted(model.objectCount, model.objectName));
  const auto row = [&](std::string_view name,
                       const std::function<std::string(const PresetFigures&)>& text) {
    page += fmt::format("  {:<{}}", name, kNameWidth);
    for (const PresetFigures& preset : figures)
      page += fmt::format("{:>{}}", text(preset), kColumnWidth);
    page += '\n';
  };
  const auto heading = [&](std::string_view name) { page += fmt::format("\n{}\n", name); };
  page += '\n';
  row("", [](const PresetFigures& p) { return p.name; });
  heading("Tree");
  row("build", [](const PresetFigures& p) { return secondsText(p.buildSeconds); });
  row("memory", [](const PresetFigures& p) { return byteText(p.subject.statistics.bytes); });
  row("memory to build",
      [](const PresetFigures& p) { return byteText(p.subject.report.peakBytes); });
  row("nodes", [](const PresetFigures& p) { return grouped(p.nodeCount()); });
  row("references",
      [](const PresetFigures& p) { return grouped(p.subject.statistics.referenceCount); });
  row("levels", [](const PresetFigures& p) { return grouped(p.subject.statistics.depth); });
  row("SAH cost", [](const PresetFigures& p) { return numberText(p.sahCost); });
  heading("Steps of a primary ray");
  row("split nodes",
      [&](const PresetFigures& p) { return numberText(perRay(p.steps.splitNodes, model)); });
  row("leaf nodes",
      [&](const PresetFigures& p) { return numberText(perRay(p.steps.leafNodes, model)); });
  row(model.objectName + "s",
      [&](const PresetFigures& p) { return numberText(perRay(p.steps.objects, model)); });
  heading("Million rays per second");
  row(fmt::format("primary ({})", grouped(model.primaryRayCount)),
      [](const PresetFigures& p) { return numberText(p.speeds.primary); });
  row(fmt::format("ao ({})", grouped(model.aoRayCount)),
      [](const PresetFigures& p) { return numberText(p.speeds.ao); });
  row(fmt::format("random ({})", grouped(model.randomRayCount)),
      [](const PresetFigures& p) { return numberText(p.speeds.random); });
  return page;
}

Json presetsJson(const ComparedModel& model, const std::vector<PresetFigures>& figures) {
  Json presets = Json::array();
  for (const PresetFigures& preset : figures) {
    presets.push_back({{"name", preset.name},
                       {"build_seconds", preset.buildSeconds},
                       {"comparable_sah_cost", preset.sahCost},
                       {"split_node_steps", perRay(preset.steps.splitNodes, model)},
                       {"leaf_node_steps", perRay(preset.steps.leafNodes, model)},
                       {"object_steps", perRay(preset.steps.objects, model)},
                       {"primary_mrays_per_second", preset.speeds.primary},
                       {"ao_mrays_per_second", preset.speeds.ao},
                       {"random_mrays_per_second", preset.speeds.random},
                       {"build", buildJson(preset.subject.options, preset.subject.report)},
                       {"tree", treeJson(preset.subject.statistics)}});
  }
  return presets;
}

std::string figuresLine(const ComparedModel& model, const PresetFigures& figures) {
  const std::uint64_t steps = figures.steps.splitNodes + figures.steps.objects;
  return fmt::format(
      "built in {}, {}, SAH cost {}, {} steps, Mrays/s: primary {}, ao {}, random {}",
      secondsText(figures.buildSeconds), byteText(figures.subject.statistics.bytes),
      numberText(figures.sahCost), numberText(perRay(steps, model)),
      numberText(figures.speeds.primary), numberText(figures.speeds.ao),
      numberText(figures.speeds.random));
}

}  // namespace planetree::tool
