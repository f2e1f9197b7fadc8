#pragma once

#include "command_options.hpp"

#include <filesystem>
#include <optional>

namespace planetree::tool {

/// What `planetree info` is asked to do.
struct InfoCommand {
  std::filesystem::path model;
  std::optional<std::filesystem::path> plot;
  TreeOptions tree;
  RunOptions run;
};

/// Adds the subcommand to the program's command line; parsing fills `command`, which must outlive
/// `app`. Values out of range throw `UsageError` while parsing. Returns the subcommand.
CLI::App* addInfoCommand(CLI::App& app, InfoCommand& command);

/// Builds the tree of the model and prints what it is like. Throws `UsageError` for options that
/// contradict each other, `Error` for what fails. Returns the exit status of the tool.
[[nodiscard]] int runInfoCommand(const InfoCommand& command);

}  // namespace planetree::tool
