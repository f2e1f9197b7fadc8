#include "render_command.hpp"

#include "exit_status.hpp"
#include "json_text.hpp"
#include "output_file.hpp"
#include "picture_metadata.hpp"
#include "progress_line.hpp"
#include "ray_files/byte_source.hpp"
#include "subject.hpp"
#include "talk.hpp"
#include "usage_error.hpp"

#include "render/file/encode_exr.hpp"
#include "render/file/encode_png.hpp"
#include "render/overlay/heat_legend.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace planetree::tool {

namespace {

namespace fs = std::filesystem;

std::string_view formatName(PictureFormat format) noexcept {
  return format == PictureFormat::Png ? "png" : "exr";
}

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

/// A name that promises another kind of file is refused, as is one that would make the picture
/// replace its model.
void checkOutputName(const RenderCommand& command) {
  if (!command.output)
    return;
  const std::string shown = command.output->string();
  if (*command.output == kStandardOutput) {
    if (::isatty(STDOUT_FILENO) == 0)
      return;
    throw UsageError("-o -: standard output is a terminal",
                     "Send the picture to a file or a program: planetree render -o - > out.png.");
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

void checkHeatOptions(const RenderCommand& command) {
  if (command.mode == render::RenderMode::Heat)
    return;
  const std::string advice = "Add --mode heat, or leave it out.";
  if (command.heatMax)
    throw UsageError("--heat-max: only --mode heat has such a scale", advice);
  if (!command.hasLegend)
    throw UsageError("--no-legend: only --mode heat has a legend", advice);
}

void checkOptionsAgree(const RenderCommand& command) {
  checkOutputName(command);
  checkHeatOptions(command);
  if (command.fovDegrees && command.camera && command.camera->fovDegrees) {
    throw UsageError("--fov: --camera gives the field of view too",
                     "Leave out --fov, or the seventh number of --camera.");
  }
  if (!command.model && command.up != render::UpAxis::Y) {
    throw UsageError("--up z: the still life has y up", "Give a MODEL, or leave out --up.");
  }
}

render::Framing framing(const RenderCommand& command) {
  render::Framing framing{.up = command.up, .showsBox = command.cellDepth.has_value()};
  framing.aspect = static_cast<double>(command.size.width) / command.size.height;
  if (command.fovDegrees)
    framing.fovDegrees = *command.fovDegrees;
  return framing;
}

/// The camera that was asked for, or else the one that shows all of the subject.
render::Camera chosenCamera(const RenderCommand& command, const render::Camera& framed) {
  render::Camera camera = framed;
  if (command.camera) {
    camera.eye = command.camera->eye;
    camera.at = command.camera->at;
    camera.up = render::upVector(command.up);
    camera.fovDegrees = command.camera->fovDegrees.value_or(framed.fovDegrees);
  }
  return camera;
}

/// How deep a tree is shows only when it is built.
void checkCellDepth(const RenderCommand& command, const Subject& subject) {
  const std::uint32_t depth = subject.statistics.depth;
  if (command.cellDepth && *command.cellDepth > depth) {
    throw UsageError(fmt::format("--show-cells {}: this tree has {}", *command.cellDepth,
                                 counted(depth, "level")),
                     depth == 1 ? "Give 1." : fmt::format("Give a number from 1 to {}.", depth));
  }
}

/// The bytes of a picture's file, and how large the picture is with its legend.
struct PictureFile {
  std::vector<std::byte> bytes;
  render::ImageSize size;
};

PictureFile encodePicture(const FinishedPicture& picture) {
  const render::Rendering& rendering = picture.rendering;
  const render::Metadata metadata = pictureMetadata(picture);
  if (chosenFormat(picture.command) == PictureFormat::Exr)
    return {encodeExr(channelImage(rendering), metadata), picture.command.size};
  render::Image image = shownImage(rendering);
  if (picture.command.mode == render::RenderMode::Heat && picture.command.hasLegend)
    image = withHeatLegend(image, *rendering.range);
  return {encodePng(image, metadata), image.size};
}

Json pointJson(const Vec3f& point) {
  return Json::array({point.x, point.y, point.z});
}

Json rangeJson(const std::optional<render::ValueRange>& range) {
  if (!range)
    return nullptr;
  return {{"darkest", range->darkest},
          {"brightest", range->brightest},
          {"min", range->lowest},
          {"mean", range->mean},
          {"max", range->highest}};
}

Json summaryJson(const FinishedPicture& picture, const PictureFile& file) {
  const RenderCommand& command = picture.command;
  const Subject& subject = picture.subject;
  return {
      {"model", command.model ? Json(command.model->string()) : Json(nullptr)},
      {"picture", outputPath(command).string()},
      {"format", formatName(chosenFormat(command))},
      {"width", file.size.width},
      {"height", file.size.height},
      {"byte_count", file.bytes.size()},
      {"command", reproducingCommand(picture)},
      {"mode", modeName(command.mode)},
      {"samples", command.samplesPerPixel},
      {"seed", command.seed},
      {"cell_depth", command.cellDepth ? Json(*command.cellDepth) : Json(nullptr)},
      {"camera",
       {{"eye", pointJson(picture.camera.eye)},
        {"at", pointJson(picture.camera.at)},
        {"up", pointJson(picture.camera.up)},
        {"fov", picture.camera.fovDegrees}}},
      {"mesh", subject.mesh},
      {"build", buildJson(subject.options, subject.report)},
      {"tree", treeJson(subject.statistics)},
      {"range", rangeJson(picture.rendering.range)},
      {"ray_count", picture.rendering.rayCount},
      {"render_seconds", picture.rendering.seconds},
  };
}

/// Standard output carries the picture or the summary, never both.
bool isJsonOnStandardError(const RenderCommand& command) {
  return command.run.isJson && command.output == kStandardOutput;
}

render::RenderSettings renderSettings(const RenderCommand& command, const Subject& subject,
                                      const render::Camera& camera) {
  return {.size = command.size,
          .camera = camera,
          .mode = command.mode,
          .samplesPerPixel = command.samplesPerPixel,
          .seed = command.seed,
          .threadCount = command.run.threadCount,
          .albedos = subject.albedos,
          .heatMax = command.heatMax,
          .cellDepth = command.cellDepth};
}

render::Rendering renderWithProgress(const render::Tracer& tracer, render::RenderSettings settings,
                                     const Talk& talk) {
  ProgressLine progress("rendering", talk.showsProgress());
  settings.keepsGoing = [&progress](double done) {
    progress.update(done);
    return true;
  };
  return renderImage(tracer, settings);
}

int renderSubject(const RenderCommand& command, const Subject& subject, const Talk& talk) {
  const render::Camera camera = chosenCamera(command, subject.camera);
  talk.say(fmt::format("view: --camera {}{}", cameraText(camera),
                       command.up == render::UpAxis::Z ? " --up z" : ""));

  const render::Rendering rendering =
      renderWithProgress(*subject.tracer, renderSettings(command, subject, camera), talk);
  sayRendering(talk, command.mode, rendering);

  const FinishedPicture picture{command, subject, camera, rendering};
  const PictureFile file = encodePicture(picture);
  const fs::path path = outputPath(command);
  writeFile(path, file.bytes);
  talk.say(fmt::format("wrote {} ({} x {}, {})",
                       path == kStandardOutput ? "standard output" : path.string(), file.size.width,
                       file.size.height, byteText(file.bytes.size())));
  if (command.run.isJson)
    printJson(summaryJson(picture, file), isJsonOnStandardError(command));
  return kDone;
}

}  // namespace

int runRenderCommand(const RenderCommand& command) {
  checkOptionsAgree(command);
  checkIsWritable(outputPath(command));
  // Talk beside the summary would keep programs from reading it.
  const Talk talk(command.run.isQuiet || isJsonOnStandardError(command));
  const BuildOptions build = buildOptions(command.tree, command.run);
  const BuildControl control = buildControl(command.run);
  const Subject subject =
      command.model ? readModelSubject(*command.model, build, control, framing(command), talk)
                    : makeStillLifeSubject(build, control, framing(command), talk);
  checkCellDepth(command, subject);
  return renderSubject(command, subject, talk);
}

}  // namespace planetree::tool
