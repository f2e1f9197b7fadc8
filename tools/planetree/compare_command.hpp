#pragma once

#include "command_options.hpp"
#include "option_values.hpp"

#include "render/framing.hpp"
#include "render/image.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace planetree::tool {

/// What `planetree compare` is asked to do.
struct CompareCommand {
  std::filesystem::path model;
  std::vector<Preset> presets;  ///< at least one when parsed
  std::optional<std::filesystem::path> output;
  render::ImageSize size{480, 360};  ///< of each picture
  std::uint32_t samplesPerPixel = 8;
  std::optional<std::uint32_t> heatMax;
  render::UpAxis up = render::UpAxis::Y;
  std::uint32_t roundCount = 5;
  std::uint32_t rayPictureSize = 512;
  RunOptions run;
};

/// Adds the subcommand to the program's command line; parsing fills `command`, which must outlive
/// `app`. Values out of range throw `UsageError` while parsing. Returns the subcommand.
CLI::App* addCompareCommand(CLI::App& app, CompareCommand& command);

/// Builds the model with each preset, measures, prints, and draws the contact sheet. Throws
/// `UsageError` for options that contradict each other, `Error` for what fails. Returns the exit
/// status of the tool.
[[nodiscard]] int runCompareCommand(const CompareCommand& command);

}  // namespace planetree::tool
