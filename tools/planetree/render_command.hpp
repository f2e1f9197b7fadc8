#pragma once

#include "command_options.hpp"
#include "option_values.hpp"

#include "render/framing.hpp"
#include "render/image.hpp"
#include "render/render_image.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace planetree::tool {

/// What can be chosen of Whitted's shading alone; what is unset has its default.
struct WhittedOptions {
  std::optional<std::uint32_t> rayDepth;
  std::optional<std::uint32_t> supersampling;  ///< the side of the grid in a pixel
  std::optional<float> threshold;              ///< 0 is none: all pixels have the whole grid
  bool hasShadows = true;
  std::optional<std::array<std::filesystem::path, 6>> background;
};

inline constexpr std::uint32_t kUsualSamplesPerPixel = 8;
inline constexpr std::uint32_t kUsualSupersampling = 4;
inline constexpr float kUsualThreshold = 0.05f;

/// What `planetree render` is asked to do.
struct RenderCommand {
  std::optional<std::filesystem::path> model;
  std::optional<std::filesystem::path> output;
  std::optional<PictureFormat> format;
  SizeOption size;
  std::optional<render::PixelWindow> crop;
  std::optional<render::RenderMode> mode;        ///< otherwise as the subject is
  std::optional<std::uint32_t> samplesPerPixel;  ///< of all modes but whitted
  std::uint64_t seed = 0;
  WhittedOptions whitted;
  bool isFlat = false;
  bool cullsBackFaces = false;
  std::optional<double> previewSeconds;
  bool showsTimes = false;
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
