#include "command_options.hpp"

#include "usage_error.hpp"

#include <planetree/node/node_layout.hpp>

#include <fmt/format.h>

#include <limits>

namespace planetree::tool {

namespace {

constexpr std::uint64_t kMaxThreadCount = 1024;

}  // namespace

// Descriptions are broken by hand: the help is not wrapped otherwise.

void addTreeOptions(CLI::App& app, TreeOptions& options) {
  const std::string tree = "Tree";
  addValue(app, "--preset", options.preset, parsePreset,
           "Build rules: default, or textbook for the rules as taught")
      ->type_name("default|textbook")
      ->default_str("default")
      ->group(tree);
  addWholeNumber(app, "--leaf-size", options.leafSize, 0, std::numeric_limits<std::uint32_t>::max(),
                 "Make leaves of this many objects or fewer; otherwise as\n"
                 "the preset says")
      ->group(tree);
  addWholeNumber(app, "--depth-limit", options.depthLimit, 1, kMaxTreeDepth,
                 "Most levels of the tree; otherwise as the preset says")
      ->group(tree);
}

void addRunOptions(CLI::App& app, RunOptions& options) {
  const std::string run = "Run";
  addWholeNumber(app, "--threads", options.threadCount, 0, kMaxThreadCount,
                 "Threads to use; 0 is as many as the machine has. The\n"
                 "result is the same for any number")
      ->default_str(fmt::format("{}", options.threadCount))
      ->group(run);
  app.add_flag("-q,--quiet", options.isQuiet, "Say nothing but errors")->group(run);
}

BuildOptions buildOptions(const TreeOptions& tree, const RunOptions& run) {
  BuildOptions options = tree.preset;
  options.threadCount = run.threadCount;
  if (tree.leafSize)
    options.leafSize = *tree.leafSize;
  if (tree.depthLimit)
    options.depthLimit = tree.depthLimit;
  return options;
}

std::filesystem::path parsePath(const OptionText& option) {
  if (option.text.empty()) {
    throw UsageError(fmt::format("{}: the path is empty", option.name), "Give the name of a file.");
  }
  return std::filesystem::path(option.text);
}

}  // namespace planetree::tool
