#include "explain_command.hpp"

#include "exit_status.hpp"
#include "instruments/print_page.hpp"
#include "instruments/ray_option.hpp"
#include "instruments/walk_json.hpp"
#include "instruments/walk_page.hpp"
#include "json_text.hpp"
#include "model.hpp"
#include "talk.hpp"

#include <nlohmann/json.hpp>

#include <concepts>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace planetree::tool {

namespace {

constexpr const char* kFooter =
    R"(The ray and the hit are printed to the last bit, all else to six digits;
--json keeps every bit of every number. docs/instruments.md walks through an
example.

Examples:
  planetree explain bunny.obj --ray 0,0.1,1,0,0,-1
      from in front of the bunny, straight at it
  planetree explain room.ply --ray 0,1,0,1,0,0.5,0,10 --any
      whether anything is in the way up to t = 10

Exit status: 0 done, whether or not there is a hit, 1 failed, 2 wrong usage.
)";

template <std::floating_point T>
int explainIn(const ExplainCommand& command) {
  const Ray<T> ray = parseRay<T>({"--ray", command.ray}, command.limits);
  const Talk talk(command.run.isQuiet);
  Model<T> model = readModel<T>(command.model, talk);
  const std::vector<std::uint32_t> sourceFaces = model.mesh.sourceFaces;
  const auto tree = buildModelTree(std::move(model), buildOptions(command.tree, command.run),
                                   buildControl(command.run), talk);
  const Walk<T> walk = command.isAnyHit ? tree.explainOcclusion(ray, command.query)
                                        : tree.explainIntersection(ray, command.query);
  const WalkContext context{
      .isAnyHit = command.isAnyHit, .bounds = tree.bounds(), .sourceFaces = sourceFaces};
  if (command.run.isJson) {
    Json json = {{"model", command.model.string()}};
    json.update(walkJson(walk, context));
    printJson(json, false);
  } else {
    printPage(walkPage(walk, context));
  }
  return kDone;
}

}  // namespace

CLI::App* addExplainCommand(CLI::App& app, ExplainCommand& command) {
  CLI::App& explain =
      *app.add_subcommand("explain", "Tell, step by step, how a ray walks through the tree");
  explain.footer(kFooter);
  addValue(explain, "MODEL", command.model, parsePath, "Model to trace; - is standard input")
      ->required()
      ->type_name("");
  addValue(
      explain, "--ray", command.ray,
      [](const OptionText& option) { return std::string(option.text); },
      "Origin, direction, and where the ray begins and ends, if not at --t-min and --t-max: "
      "ox,oy,oz,dx,dy,dz[,tMin,tMax]")
      ->required()
      ->type_name("RAY");
  addQueryFlags(explain, command.isAnyHit, command.isDouble);
  addQueryOptions(explain, command.query);
  addRayLimits(explain, command.limits);
  addTreeOptions(explain, command.tree);
  addRunOptions(explain, command.run);
  addJsonOption(explain, command.run);
  return &explain;
}

int runExplainCommand(const ExplainCommand& command) {
  return command.isDouble ? explainIn<double>(command) : explainIn<float>(command);
}

}  // namespace planetree::tool
