#pragma once

#include "option_values.hpp"
#include "render_command.hpp"

#include <cstdint>
#include <vector>

namespace planetree::tool {

/// What `planetree compare` is asked to do.
struct CompareCommand {
  /// Of each preset; the model, the output and the run are the command's own.
  RenderCommand picture;
  std::vector<Preset> presets;  ///< at least one when parsed
  std::uint32_t roundCount = 5;
  std::uint32_t rayPictureSize = 512;
};

/// Adds the subcommand to the program's command line; parsing fills `command`, which must outlive
/// `app`. Values out of range throw `UsageError` while parsing. Returns the subcommand.
CLI::App* addCompareCommand(CLI::App& app, CompareCommand& command);

/// Builds the subject with each preset, measures, prints, and draws the contact sheet. Throws
/// `UsageError` for options that contradict each other, `Error` for what fails. Returns the exit
/// status of the tool.
[[nodiscard]] int runCompareCommand(const CompareCommand& command);

}  // namespace planetree::tool
