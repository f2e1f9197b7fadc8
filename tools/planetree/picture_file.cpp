#include "picture_file.hpp"

#include "output_file.hpp"
#include "picture_plan.hpp"
#include "ray_files/byte_source.hpp"
#include "usage_error.hpp"

#include "render/file/encode_exr.hpp"
#include "render/file/encode_png.hpp"
#include "render/overlay/heat_legend.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <optional>
#include <string>
#include <system_error>

namespace planetree::tool {

namespace fs = std::filesystem;

namespace {

/// What the name of a file promises; `UsageError` if that is no picture. Names without an extension
/// and standard output promise nothing.
std::optional<PictureFormat> formatOfName(const fs::path& path) {
  const std::string extension = lowerCaseExtension(path);
  if (path == kStandardOutput || extension.empty())
    return std::nullopt;
  if (extension == ".png")
    return PictureFormat::Png;
  if (extension == ".exr")
    return PictureFormat::Exr;
  throw UsageError(fmt::format("-o {}: pictures are PNG or EXR files", path.string()),
                   "Give a name that ends in .png or .exr.");
}

}  // namespace

std::string_view formatName(PictureFormat format) noexcept {
  return format == PictureFormat::Png ? "png" : "exr";
}

PictureFormat chosenFormat(const RenderCommand& command) {
  if (command.format)
    return *command.format;
  const auto promised = command.output ? formatOfName(*command.output) : std::nullopt;
  return promised.value_or(PictureFormat::Png);
}

fs::path outputPath(const RenderCommand& command) {
  if (command.output)
    return *command.output;
  const bool hasName = command.model && *command.model != kStandardInput;
  const fs::path stem = hasName ? command.model->stem() : fs::path("render");
  return fs::path(stem).concat(fmt::format(".{}", formatName(chosenFormat(command))));
}

bool isStandardOutput(const RenderCommand& command) {
  return command.output == kStandardOutput;
}

void checkOutputName(const RenderCommand& command) {
  if (!command.output)
    return;
  const std::string shown = command.output->string();
  if (*command.output == kStandardOutput) {
    if (::isatty(STDOUT_FILENO) == 0)
      return;
    throw UsageError("-o -: standard output is a terminal",
                     "Send the picture to a file or a program: -o - > out.png.");
  }
  const auto promised = formatOfName(*command.output);
  if (command.format && promised && *command.format != *promised) {
    throw UsageError(
        fmt::format("-o {}: --format {} is something else", shown, formatName(*command.format)),
        "Leave out --format, or change the name.");
  }
  std::error_code missing;
  if (command.model && fs::equivalent(*command.model, *command.output, missing)) {
    throw UsageError(fmt::format("-o {}: that is the model", shown),
                     "Give the picture another name.");
  }
}

PictureFile encodePicture(const FinishedPicture& picture) {
  const render::Rendering& rendering = picture.rendering;
  const render::Metadata metadata = pictureMetadata(picture);
  if (chosenFormat(picture.command) == PictureFormat::Exr)
    return {encodeExr(channelImage(rendering), metadata), rendering.window.size};
  render::Image image = shownImage(rendering);
  if (picture.plan.mode == render::RenderMode::Heat && picture.command.hasLegend)
    image = withHeatLegend(image, *rendering.range);
  return {encodePng(image, metadata), image.size};
}

}  // namespace planetree::tool
