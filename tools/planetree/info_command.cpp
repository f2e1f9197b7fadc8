#include "info_command.hpp"

#include "exit_status.hpp"
#include "instruments/exact_json.hpp"
#include "instruments/print_page.hpp"
#include "instruments/tree_account.hpp"
#include "instruments/tree_page.hpp"
#include "instruments/tree_plot.hpp"
#include "json_text.hpp"
#include "model.hpp"
#include "output_file.hpp"
#include "talk.hpp"
#include "usage_error.hpp"

#include <planetree/traversal/instruction_set.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace planetree::tool {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFooter =
    R"(The levels of the tree are counted from 1 at the root. The SAH cost is what
the surface area heuristic expects a ray through the bounds to pay, as the
builder counts it; docs/instruments.md says how to read the rest.

Examples:
  planetree info bunny.obj
      the tree in numbers and charts
  planetree info bunny.obj --plot bunny.svg
      the charts as a picture, too
  planetree info bunny.obj --json | jq .tree.sah_cost
      one number for a script

Exit status: 0 done, 1 failed, 2 wrong usage.
)";

bool writesPlotToStandardOutput(const InfoCommand& command) {
  return command.plot && *command.plot == kStandardOutput;
}

void checkPlotIsNotTheModel(const InfoCommand& command) {
  std::error_code missing;
  if (command.plot && fs::equivalent(command.model, *command.plot, missing)) {
    throw UsageError(fmt::format("--plot {}: that is the model", command.plot->string()),
                     "Give the picture another name.");
  }
}

std::vector<std::string> skippedPolygons(const MeshReadReport& report) {
  std::vector<std::string> texts;
  for (const SkippedPolygon& skipped : report.skipped)
    texts.push_back(fmt::format("face {} {}", skipped.polygon, skipped.reason));
  return texts;
}

std::vector<std::string> skippedTriangles(const BuildReport& report,
                                          const std::vector<std::uint32_t>& sourceFaces) {
  std::vector<std::string> texts;
  for (const SkippedObject& skipped : report.skipped) {
    const std::uint32_t face =
        sourceFaces.empty() ? skipped.primitive : sourceFaces[skipped.primitive];
    texts.push_back(fmt::format("face {} {}", face, reasonText(skipped.reason)));
  }
  return texts;
}

struct Accounts {
  TreeAccount tree;
  Json mesh;
};

Accounts takeStock(const InfoCommand& command, const BuildOptions& options) {
  // What would be said here stands on the page.
  const Talk talk = Talk::ofProgress(!command.run.isQuiet);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  Model<float> model = readModel<float>(command.model, talk);
  const double readSeconds = std::chrono::duration<double>(Clock::now() - start).count();

  const MeshSize size{.faceCount = model.mesh.faces.size(),
                      .vertexCount = model.mesh.positions.size()};
  const std::vector<std::uint32_t> sourceFaces = model.mesh.sourceFaces;
  const auto report = model.report;
  Json mesh = meshJson(size, report);
  const auto tree = buildModelTree(std::move(model), options, buildControl(command.run), talk);
  return {.tree = {.model = command.model.string(),
                   .format = report.formatName,
                   .vertexCount = size.vertexCount,
                   .triangleCount = size.faceCount,
                   .polygonCount = report.polygonCount,
                   .skippedPolygonCount = report.skippedPolygonCount,
                   .skippedPolygons = skippedPolygons(report),
                   .skippedTriangles = skippedTriangles(tree.report(), sourceFaces),
                   .unreadPrimitiveCount = report.unreadPrimitiveCount,
                   .tooLargeCount = report.tooLargeCount,
                   .remarks = report.remarks,
                   .readSeconds = readSeconds,
                   .bounds = tree.bounds(),
                   .build = tree.report(),
                   .tree = tree.statistics(),
                   .instructionSet = activeInstructionSet(),
                   .supportedInstructionSets = supportedInstructionSets()},
          .mesh = std::move(mesh)};
}

Json levelsJson(const TreeStatistics& tree) {
  Json levels = Json::array();
  for (const LevelStatistics& level : tree.levels) {
    levels.push_back({
        {"split_node_count", level.splitNodeCount},
        {"leaf_node_count", level.leafNodeCount},
        {"empty_leaf_count", level.emptyLeafCount},
        {"reference_count", level.referenceCount},
        {"traversal_cost", level.traversalCost},
        {"intersection_cost", level.intersectionCost},
    });
  }
  return levels;
}

Json leafSizesJson(const TreeStatistics& tree) {
  Json sizes = Json::array();
  for (const LeafSizeCount& size : tree.leafSizes)
    sizes.push_back({{"object_count", size.objectCount}, {"leaf_count", size.leafCount}});
  return sizes;
}

Json infoJson(const Accounts& accounts, const BuildOptions& options) {
  const TreeAccount& account = accounts.tree;
  Json tree = treeJson(account.tree);
  tree["references_per_object"] = account.perObject(account.tree.referenceCount);
  tree["mean_leaf"] = account.meanLeafSize();
  tree["levels"] = levelsJson(account.tree);
  tree["leaf_sizes"] = leafSizesJson(account.tree);
  return {
      {"model", account.model},
      {"mesh", accounts.mesh},
      {"skipped_polygons", account.skippedPolygons},
      {"skipped_triangles", account.skippedTriangles},
      {"remarks", account.remarks},
      {"bounds", exactJson(account.bounds)},
      {"read_seconds", account.readSeconds},
      {"build", buildJson(options, account.build)},
      {"tree", std::move(tree)},
      {"instruction_set", account.instructionSet},
      {"supported_instruction_sets", account.supportedInstructionSets},
  };
}

void writePlot(const TreeAccount& account, const fs::path& path, const Talk& talk) {
  const std::string svg = treePlot(account);
  writeFile(path, std::as_bytes(std::span(svg)));
  talk.say(fmt::format("wrote {} ({})", path == kStandardOutput ? "standard output" : path.string(),
                       byteText(svg.size())));
}

}  // namespace

CLI::App* addInfoCommand(CLI::App& app, InfoCommand& command) {
  CLI::App& info = *app.add_subcommand("info", "Show what the tree of a model is like");
  info.footer(kFooter);
  addValue(info, "MODEL", command.model, parsePath, "Model to look at; - is standard input")
      ->required()
      ->type_name("");
  addValue(info, "--plot", command.plot, parsePath,
           "Draw the charts as an SVG picture into this file; - is standard output, and then the "
           "page is left out")
      ->type_name("FILE");
  addTreeOptions(info, command.tree);
  addRunOptions(info, command.run);
  addJsonOption(info, command.run);
  return &info;
}

int runInfoCommand(const InfoCommand& command) {
  checkPlotIsNotTheModel(command);
  if (command.plot)
    checkIsWritable(*command.plot);
  const BuildOptions options = buildOptions(command.tree, command.run);
  const Accounts accounts = takeStock(command, options);

  const bool isPlotData = writesPlotToStandardOutput(command);
  const Talk talk(command.run.isQuiet || (isPlotData && command.run.isJson));
  if (command.plot)
    writePlot(accounts.tree, *command.plot, talk);
  if (command.run.isJson) {
    printJson(infoJson(accounts, options), isPlotData);
  } else if (!isPlotData) {
    printPage(treePage(accounts.tree));
  }
  return kDone;
}

}  // namespace planetree::tool
