#pragma once

#include "command_options.hpp"
#include "option_values.hpp"

#include "render/framing.hpp"
#include "render/render_image.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace planetree::tool {

/// What `planetree render` is asked to do.
struct RenderCommand {
  std::optional<std::filesystem::path> model;
  std::optional<std::filesystem::path> output;
  std::optional<PictureFormat> format;
  render::ImageSize size{800, 600};
  render::RenderMode mode = render::RenderMode::AmbientOcclusion;
  std::uint32_t samplesPerPixel = 8;
  std::uint64_t seed = 0;
  std::optional<std::uint32_t> heatMax;  ///< the steps of the brightest colour
  bool hasLegend = true;                 ///< of heat
  std::optional<std::uint32_t> cellDepth;
  std::optional<CameraOption> camera;
  std::optional<float> fovDegrees;
  render::UpAxis up = render::UpAxis::Y;
  TreeOptions tree;
  RunOptions run;
};

/// Adds the subcommand to the program's command line; parsing fills `command`, which must outlive
/// `app`. Values out of range throw `UsageError` while parsing. Returns the subcommand.
CLI::App* addRenderCommand(CLI::App& app, RenderCommand& command);

/// Renders. Throws `UsageError` for options that contradict each other, `Error` for what fails.
/// Returns the exit status of the tool.
[[nodiscard]] int runRenderCommand(const RenderCommand& command);

}  // namespace planetree::tool
