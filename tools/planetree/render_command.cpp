#include "render_command.hpp"

#include "exit_status.hpp"
#include "interruption.hpp"
#include "output_file.hpp"
#include "progress_line.hpp"
#include "subject.hpp"
#include "talk.hpp"
#include "usage_error.hpp"

#include "render/file/encode_png.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <limits>
#include <string>
#include <vector>

namespace planetree::tool {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxSamplesPerPixel = 65536;

constexpr const char* kExamples = R"(Examples:
  planetree render
      a still life made in code, as render.png
  planetree render bunny.obj
      ambient occlusion of a model, as bunny.png
  planetree render bunny.obj --mode heat -o bunny-heat.png
      how much work each ray is
  planetree render scan.ply --up z --size 1920x1080 --samples 32
      a model with z up, larger and smoother
  planetree render room.ply --camera -15,-9,0.5,10,-7,-1,70
      from the eye (-15, -9, 0.5) toward (10, -7, -1), 70 degrees
  planetree render bunny.obj --quiet -o - | display
      the PNG on standard output

Exit status: 0 done, 1 failed, 2 wrong usage.
)";

fs::path outputPath(const RenderCommand& command) {
  if (command.output)
    return *command.output;
  return command.model ? command.model->stem().concat(".png") : fs::path("render.png");
}

/// The picture is always a PNG; a name that promises something else is refused, as is one that
/// would make the picture replace its model.
void checkOutputName(const RenderCommand& command) {
  if (!command.output)
    return;
  if (*command.output == kStandardOutput) {
    if (::isatty(STDOUT_FILENO) == 0)
      return;
    throw UsageError("-o -: standard output is a terminal",
                     "Send the picture to a file or a program: planetree render -o - > out.png.");
  }
  const std::string extension = lowerCaseExtension(*command.output);
  if (!extension.empty() && extension != ".png") {
    throw UsageError(fmt::format("-o {}: pictures are PNG files", command.output->string()),
                     "Give a name that ends in .png.");
  }
  std::error_code missing;
  if (command.model && fs::equivalent(*command.model, *command.output, missing)) {
    throw UsageError(fmt::format("-o {}: that is the model", command.output->string()),
                     "Give the picture another name.");
  }
}

void checkOptionsAgree(const RenderCommand& command) {
  checkOutputName(command);
  if (command.fovDegrees && command.camera && command.camera->fovDegrees) {
    throw UsageError("--fov: --camera gives the field of view too",
                     "Leave out --fov, or the seventh number of --camera.");
  }
  if (!command.model && command.up != render::UpAxis::Y) {
    throw UsageError("--up z: the still life has y up", "Give a MODEL, or leave out --up.");
  }
}

render::Framing framing(const RenderCommand& command) {
  render::Framing framing{.up = command.up};
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

int sayInterrupted() {
  printToStandardError("planetree: interrupted, and no picture was written\n");
  return kFailed;
}

int renderSubject(const RenderCommand& command, const Subject& subject, const Talk& talk) {
  const Interruption interruption;
  const auto isWanted = [&] { return !interruption.isRequested(); };

  render::RenderSettings settings{.size = command.size,
                                  .camera = chosenCamera(command, subject.camera),
                                  .mode = command.mode,
                                  .samplesPerPixel = command.samplesPerPixel,
                                  .seed = command.seed,
                                  .threadCount = command.run.threadCount,
                                  .albedos = subject.albedos};
  talk.say(fmt::format("view: --camera {}{}", cameraText(settings.camera),
                       command.up == render::UpAxis::Z ? " --up z" : ""));

  std::optional<render::Rendering> rendering;
  {
    ProgressLine progress("rendering", !talk.isQuiet());
    settings.keepsGoing = [&](double done) {
      progress.update(done);
      return isWanted();
    };
    rendering = renderImage(*subject.tracer, settings);
  }
  if (!rendering)
    return sayInterrupted();
  sayRendering(talk, command.mode, *rendering);

  const std::vector<std::byte> png = encodePng(shownImage(*rendering));
  const fs::path path = outputPath(command);
  if (!writeFile(path, png, isWanted))
    return sayInterrupted();
  talk.say(fmt::format("wrote {} ({} x {}, {})",
                       path == kStandardOutput ? "standard output" : path.string(),
                       command.size.width, command.size.height, byteText(png.size())));
  return kDone;
}

// Descriptions are broken by hand: the help is not wrapped otherwise.

void addPictureOptions(CLI::App& app, RenderCommand& command) {
  addValue(app, "MODEL", command.model, parsePath,
           "Model to render: PLY, STL or OBJ, told apart by content;\n"
           "without one, a still life made in code")
      ->type_name("");
  addValue(app, "-o,--output", command.output, parsePath,
           "PNG file to write, replacing an older one; - is standard\n"
           "output. Otherwise named after the model, in this folder,\n"
           "or render.png")
      ->type_name("FILE");
  addValue(app, "--size", command.size, parseSize, "Width and height in pixels")
      ->type_name("WxH")
      ->default_str(fmt::format("{}x{}", command.size.width, command.size.height));
  addValue(app, "--mode", command.mode, parseMode,
           "What to show: ao (ambient occlusion), normals, depth (near\n"
           "is bright), or heat (work of each ray)")
      ->type_name("ao|normals|depth|heat")
      ->default_str("ao");
  addWholeNumber(app, "--samples", command.samplesPerPixel, 1, kMaxSamplesPerPixel,
                 "Rays per pixel; in mode ao each that sees a surface sends\n"
                 "four more. Powers of two are spread best")
      ->default_str(fmt::format("{}", command.samplesPerPixel));
  const auto parseSeed = [](const OptionText& option) {
    return parseWholeNumber(option, 0, std::numeric_limits<std::uint64_t>::max());
  };
  addValue(app, "--seed", command.seed, parseSeed, "Another pattern of samples")
      ->type_name("N")
      ->default_str(fmt::format("{}", command.seed));
}

void addViewOptions(CLI::App& app, RenderCommand& command) {
  const std::string view = "View";
  addValue(app, "--camera", command.camera, parseCamera,
           "The eye, the point in the middle of the picture, and the\n"
           "field of view: six or seven numbers. Otherwise a view of\n"
           "the whole model, from its right and above")
      ->type_name("ex,ey,ez,ax,ay,az[,fov]")
      ->group(view);
  addValue(app, "--fov", command.fovDegrees, parseFov,
           "Field of view from the lower to the upper edge, in degrees")
      ->type_name("DEGREES")
      ->default_str(fmt::format("{}", render::Framing{}.fovDegrees))
      ->group(view);
  addValue(app, "--up", command.up, parseUpAxis, "Which way is up in the model")
      ->type_name("y|z")
      ->default_str("y")
      ->group(view);
}

}  // namespace

CLI::App* addRenderCommand(CLI::App& app, RenderCommand& command) {
  CLI::App& render = *app.add_subcommand("render", "Render a model, or a still life made in code");
  render.footer(kExamples);
  addPictureOptions(render, command);
  addViewOptions(render, command);
  addTreeOptions(render, command.tree);
  addRunOptions(render, command.run);
  return &render;
}

int runRenderCommand(const RenderCommand& command) {
  checkOptionsAgree(command);
  checkIsWritable(outputPath(command));
  const Talk talk(command.run.isQuiet);
  const BuildOptions build = buildOptions(command.tree, command.run);
  const Subject subject = command.model
                              ? readModelSubject(*command.model, build, framing(command), talk)
                              : makeStillLifeSubject(build, framing(command), talk);
  return renderSubject(command, subject, talk);
}

}  // namespace planetree::tool
