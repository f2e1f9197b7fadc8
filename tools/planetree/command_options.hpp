#pragma once

#include "option_values.hpp"

#include <planetree/split/build_control.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/traversal/query_options.hpp>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

/// Options that have the same names, values and words in every subcommand.
///
/// What stands behind an option's name says what it takes, to people and to the completions alike:
/// "a|b" is one of these words, FILE a file, MODEL a model; see option_syntax.hpp.
namespace planetree::tool {

/// How the tree is to be built.
struct TreeOptions {
  BuildOptions preset;
  std::vector<std::function<void(BuildOptions&)>> changes;  ///< to the preset
};

/// Where a ray begins and ends, unless it says so itself.
struct RayLimits {
  double tMin = 0.0;
  double tMax = std::numeric_limits<double>::infinity();
};

/// How the tool is to run.
struct RunOptions {
  std::uint32_t threadCount = 0;
  std::uint64_t memoryLimit = 0;  ///< of a build, in bytes; 0 is none
  bool isQuiet = false;
  bool isJson = false;
};

/// One option for each member of `BuildOptions`, under its name.
void addTreeOptions(CLI::App& app, TreeOptions& options);
/// --culls-back-faces.
void addCullingFlag(CLI::App& app, bool& cullsBackFaces);
/// One option for each member of `QueryOptions` but the filter.
void addQueryOptions(CLI::App& app, QueryOptions& options);
void addRayLimits(CLI::App& app, RayLimits& limits);
/// --any and --double.
void addQueryFlags(CLI::App& app, bool& isAnyHit, bool& isDouble);
/// --threads, --memory-limit and --quiet.
void addRunOptions(CLI::App& app, RunOptions& options);
/// --json, for subcommands that print with `printJson` what they otherwise say.
void addJsonOption(CLI::App& app, RunOptions& options);

/// The preset with everything that was asked for besides.
[[nodiscard]] BuildOptions buildOptions(const TreeOptions& tree, const RunOptions& run);

/// How the run holds its builds.
[[nodiscard]] BuildControl buildControl(const RunOptions& run);

/// Throws `UsageError` if nothing lies between the limits.
void checkRayLimits(const RayLimits& limits);

/// The path of a file; `UsageError` if it is empty.
[[nodiscard]] std::filesystem::path parsePath(const OptionText& option);

/// Adds an option whose text `parse` turns into the value.
template <class Value, class Parse>
CLI::Option* addValue(CLI::App& app, const std::string& names, Value& value, const Parse& parse,
                      const std::string& description) {
  const std::string shownName = names.substr(names.rfind(',') + 1);
  return app.add_option_function<std::string>(
      names,
      [&value, parse, shownName](const std::string& text) {
        value = parse(OptionText{shownName, text});
      },
      description);
}

/// Adds an option that is a whole number.
template <class Value>
CLI::Option* addWholeNumber(CLI::App& app, const std::string& name, Value& value,
                            std::uint64_t lowest, std::uint64_t highest,
                            const std::string& description) {
  const auto parse = [lowest, highest](const OptionText& option) {
    return static_cast<std::uint32_t>(parseWholeNumber(option, lowest, highest));
  };
  return addValue(app, name, value, parse, description)->type_name("N");
}

}  // namespace planetree::tool
