#pragma once

#include "command_options.hpp"
#include "output_file.hpp"
#include "ray_files/table_format.hpp"

#include <filesystem>
#include <optional>

namespace planetree::tool {

/// What `planetree trace` is asked to do.
struct TraceCommand {
  std::filesystem::path model;
  std::filesystem::path rays;
  std::filesystem::path hits = kStandardOutput;
  std::optional<TableFormat> format;
  bool isAnyHit = false;
  bool isAllHits = false;
  bool isDouble = false;
  QueryOptions query;
  RayLimits limits;
  TreeOptions tree;
  RunOptions run;
};

/// Adds the subcommand to the program's command line; parsing fills `command`, which must outlive
/// `app`. Values out of range throw `UsageError` while parsing. Returns the subcommand.
CLI::App* addTraceCommand(CLI::App& app, TraceCommand& command);

/// Traces. Throws `UsageError` for options that contradict each other, `Error` for what fails.
/// Returns the exit status of the tool.
[[nodiscard]] int runTraceCommand(const TraceCommand& command);

}  // namespace planetree::tool
