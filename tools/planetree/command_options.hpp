#pragma once

#include "option_values.hpp"

#include <planetree/split/build_options.hpp>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

/// Options that have the same names, values and words in every subcommand.
namespace planetree::tool {

/// How the tree is to be built.
struct TreeOptions {
  BuildOptions preset;
  std::optional<std::uint32_t> leafSize;
  std::optional<std::uint32_t> depthLimit;
};

/// How the tool is to run.
struct RunOptions {
  std::uint32_t threadCount = 0;
  bool isQuiet = false;
};

void addTreeOptions(CLI::App& app, TreeOptions& options);
void addRunOptions(CLI::App& app, RunOptions& options);

/// The preset with everything that was asked for besides.
[[nodiscard]] BuildOptions buildOptions(const TreeOptions& tree, const RunOptions& run);

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
