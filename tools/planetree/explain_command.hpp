#pragma once

#include "command_options.hpp"

#include <planetree/traversal/query_options.hpp>

#include <filesystem>
#include <string>

namespace planetree::tool {

/// What `planetree explain` is asked to do.
struct ExplainCommand {
  std::filesystem::path model;
  std::string ray;  ///< as given; what its numbers are depends on the precision
  bool isAnyHit = false;
  bool isDouble = false;
  QueryOptions query;
  RayLimits limits;
  TreeOptions tree;
  RunOptions run;
};

/// Adds the subcommand to the program's command line; parsing fills `command`, which must outlive
/// `app`. Values out of range throw `UsageError` while parsing. Returns the subcommand.
CLI::App* addExplainCommand(CLI::App& app, ExplainCommand& command);

/// Prints the walk of the ray. Throws `UsageError` for a ray that is none, `Error` for what fails.
/// Returns the exit status of the tool.
[[nodiscard]] int runExplainCommand(const ExplainCommand& command);

}  // namespace planetree::tool
