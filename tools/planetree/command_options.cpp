#include "command_options.hpp"

#include "usage_error.hpp"

#include <planetree/node/node_layout.hpp>

#include <fmt/format.h>

#include <optional>
#include <string_view>

namespace planetree::tool {

namespace {

constexpr std::uint64_t kMaxThreadCount = 1024;
constexpr std::uint64_t kLargestCount = std::numeric_limits<std::uint32_t>::max();

std::string text(std::uint32_t number) {
  return fmt::format("{}", number);
}

std::string text(double number) {
  return fmt::format("{:g}", number);
}

std::string text(bool isOn) {
  return std::string(switchName(isOn));
}

std::string text(PlanarRule rule) {
  return std::string(planarRuleName(rule));
}

std::string text(std::optional<std::uint32_t> depthLimit) {
  return depthLimit ? text(*depthLimit) : "by the number of objects";
}

/// "(default 4, textbook 10)": a member in the default preset, and in those where it differs.
template <class Member>
std::string presetText(const Member& member) {
  BuildOptions defaults;
  const std::string usual = text(member(defaults));
  std::string shown = "default " + usual;
  for (auto [name, preset] : presets()) {
    if (const std::string value = text(member(preset)); value != usual)
      shown += fmt::format(", {} {}", name, value);
  }
  return fmt::format("({})", shown);
}

/// "fast|balanced|..."
std::string presetNames() {
  std::string names;
  for (const auto& [name, preset] : presets())
    names += fmt::format("{}{}", names.empty() ? "" : "|", name);
  return names;
}

/// Adds the option for one member of `BuildOptions`, which `member` picks.
template <class Member, class Parse>
CLI::Option* addTreeOption(CLI::App& app, TreeOptions& options, const std::string& name,
                           const Member& member, const Parse& parse,
                           const std::string& description) {
  return app
      .add_option_function<std::string>(
          name,
          [&options, member, parse, name](const std::string& text) {
            const auto value = parse(OptionText{name, text});
            options.changes.push_back(
                [member, value](BuildOptions& build) { member(build) = value; });
          },
          fmt::format("{} {}", description, presetText(member)))
      ->group("Tree");
}

auto wholeNumberFrom(std::uint64_t lowest, std::uint64_t highest) {
  return [lowest, highest](const OptionText& option) {
    return static_cast<std::uint32_t>(parseWholeNumber(option, lowest, highest));
  };
}

void addLeafOptions(CLI::App& app, TreeOptions& options) {
  addTreeOption(
      app, options, "--leaf-size", [](BuildOptions & build) -> auto& { return build.leafSize; },
      wholeNumberFrom(0, kLargestCount), "Make a leaf of this many objects or fewer")
      ->type_name("N");
  addTreeOption(
      app, options, "--depth-limit", [](BuildOptions & build) -> auto& { return build.depthLimit; },
      wholeNumberFrom(1, kMaxTreeDepth),
      fmt::format("Most levels of the tree, from 1 to {}", kMaxTreeDepth))
      ->type_name("N");
  addTreeOption(
      app, options, "--stops-by-cost",
      [](BuildOptions & build) -> auto& { return build.stopsByCost; }, parseSwitch,
      "Make a leaf where no split is expected to be cheaper")
      ->type_name("on|off");
}

void addCostOptions(CLI::App& app, TreeOptions& options) {
  addTreeOption(
      app, options, "--traversal-cost",
      [](BuildOptions & build) -> auto& { return build.cost.traversalCost; }, parseCost,
      "What a ray is believed to pay for a split node; only the ratio of the two costs matters")
      ->type_name("COST");
  addTreeOption(
      app, options, "--intersection-cost",
      [](BuildOptions & build) -> auto& { return build.cost.intersectionCost; }, parseCost,
      "What it is believed to pay for an object in a leaf")
      ->type_name("COST");
  addTreeOption(
      app, options, "--face-cost",
      [](BuildOptions & build) -> auto& { return build.cost.faceCost; }, parseCost,
      "The same for a face of a mesh, in a tree that holds nothing else")
      ->type_name("COST");
  addTreeOption(
      app, options, "--empty-bonus",
      [](BuildOptions & build) -> auto& { return build.cost.emptyBonus; }, parsePart,
      "The part of a split's cost that is forgiven if one side is empty, from 0 to less than 1")
      ->type_name("PART");
}

void addSplitOptions(CLI::App& app, TreeOptions& options) {
  addTreeOption(
      app, options, "--allows-empty-cells",
      [](BuildOptions & build) -> auto& { return build.allowsEmptyCells; }, parseSwitch,
      "Let splits cut off empty space")
      ->type_name("on|off");
  addTreeOption(
      app, options, "--clips-references",
      [](BuildOptions & build) -> auto& { return build.clipsReferences; }, parseSwitch,
      "Count an object only in cells that its surface touches, not its box alone")
      ->type_name("on|off");
  addTreeOption(
      app, options, "--planar-rule", [](BuildOptions & build) -> auto& { return build.planarRule; },
      parsePlanarRule, "Which side of a split gets the objects that lie in its plane")
      ->type_name("cheaper-side|normal-sign");
  addTreeOption(
      app, options, "--exact-planes",
      [](BuildOptions & build) -> auto& { return build.exactPlanes; }, parseSwitch,
      "Find the cheapest of all planes, not only one near the cheapest edge of some bins")
      ->type_name("on|off");
  addTreeOption(
      app, options, "--retracts-splits",
      [](BuildOptions & build) -> auto& { return build.retractsSplits; }, parseSwitch,
      "Take splits back that do not pay once all below them is built")
      ->type_name("on|off");
  addTreeOption(
      app, options, "--references-per-object",
      [](BuildOptions & build) -> auto& { return build.referencesPerObject; },
      wholeNumberFrom(0, kLargestCount),
      "How many cells may hold an object, on average; 0 sets no bound")
      ->type_name("N");
}

}  // namespace

void addTreeOptions(CLI::App& app, TreeOptions& options) {
  addValue(app, "--preset", options.preset, parsePreset,
           "Build rules: fast builds in a fraction of the time, high takes longer for faster rays, "
           "textbook follows the rules as taught; the options below change single rules")
      ->type_name(presetNames())
      ->default_str("balanced")
      ->group("Tree");
  addLeafOptions(app, options);
  addCostOptions(app, options);
  addSplitOptions(app, options);
}

void addCullingFlag(CLI::App& app, bool& cullsBackFaces) {
  app.add_flag("--culls-back-faces", cullsBackFaces,
               "Leave out surfaces seen from behind: triangles whose corners run clockwise")
      ->group("Query");
}

void addQueryOptions(CLI::App& app, QueryOptions& options) {
  addValue(app, "--mask", options.mask, parseMask,
           "See only geometries whose mask shares a bit with this one; models have all bits set")
      ->type_name("BITS")
      ->default_str(fmt::format("{:#x}", options.mask))
      ->group("Query");
  addCullingFlag(app, options.cullsBackFaces);
  app.add_flag("--crossings", options.crossings,
               "Count edges and vertices so that a ray into a closed mesh hits one triangle there, "
               "not all that meet")
      ->group("Query");
  app.add_option_function<std::string>(
         "--skip",
         [&options](const std::string& text) {
           // A model is one geometry.
           options.skip = {.geometry = 0,
                           .primitive = wholeNumberFrom(0, kLargestCount - 1)({"--skip", text})};
         },
         "Leave out this triangle, counted from 0, such as the one that the rays start on")
      ->type_name("TRIANGLE")
      ->group("Query");
}

void addRayLimits(CLI::App& app, RayLimits& limits) {
  addValue(app, "--t-min", limits.tMin, parseDistance,
           "Where rays begin that do not say so themselves, in units of the direction's length")
      ->type_name("T")
      ->default_str(fmt::format("{:g}", limits.tMin))
      ->group("Query");
  addValue(app, "--t-max", limits.tMax, parseDistance, "Where they end")
      ->type_name("T")
      ->default_str(fmt::format("{:g}", limits.tMax))
      ->group("Query");
}

void addQueryFlags(CLI::App& app, bool& isAnyHit, bool& isDouble) {
  app.add_flag("--any", isAnyHit, "Find only whether there is any hit, which is faster")
      ->group("Query");
  app.add_flag("--double", isDouble,
               "Read the model and trace in double, as float64 rays are by themselves")
      ->group("Query");
}

void addRunOptions(CLI::App& app, RunOptions& options) {
  addWholeNumber(app, "--threads", options.threadCount, 0, kMaxThreadCount,
                 "Threads to use; 0 is as many as the machine has. The result is the same for any "
                 "number")
      ->default_str(fmt::format("{}", options.threadCount))
      ->group("Run");
  addValue(app, "--memory-limit", options.memoryLimit, parseByteCount,
           "The most memory that building the tree may take besides the model, such as 500M or "
           "2GiB; 0 is what the machine has")
      ->type_name("SIZE")
      ->default_str(fmt::format("{}", options.memoryLimit))
      ->group("Run");
  app.add_flag("-q,--quiet", options.isQuiet, "Say nothing but errors")->group("Run");
}

void addJsonOption(CLI::App& app, RunOptions& options) {
  app.add_flag("--json", options.isJson,
               "Print the figures as JSON: on standard output, or on standard error, alone, where "
               "data goes to standard output")
      ->group("Run");
}

BuildOptions buildOptions(const TreeOptions& tree, const RunOptions& run) {
  BuildOptions options = tree.preset;
  for (const auto& change : tree.changes)
    change(options);
  options.threadCount = run.threadCount;
  return options;
}

BuildControl buildControl(const RunOptions& run) {
  BuildControl control;
  control.memoryLimit = run.memoryLimit;
  return control;
}

void checkRayLimits(const RayLimits& limits) {
  if (limits.tMin > limits.tMax) {
    throw UsageError(fmt::format("--t-min {:g}: rays end at {:g}", limits.tMin, limits.tMax),
                     "Give a smaller --t-min, or a larger --t-max.");
  }
}

std::filesystem::path parsePath(const OptionText& option) {
  if (option.text.empty()) {
    throw UsageError(fmt::format("{}: the path is empty", option.name), "Give the name of a file.");
  }
  return std::filesystem::path(option.text);
}

}  // namespace planetree::tool
