#include "render_command.hpp"

#include <planetree/node/node_layout.hpp>

#include <fmt/format.h>

#include <limits>
#include <string>

namespace planetree::tool {

namespace {

constexpr std::uint64_t kMaxSamplesPerPixel = 65536;

constexpr const char* kFooter = R"(Pictures:
  PNG           what a screen shows. Heat has a legend below it: the file is
                higher than --size says, and the picture itself is not
  EXR           numbers. R, G, B, A is the picture in linear light without
                the backdrop; Z the depth, N.X, N.Y, N.Z the normal, steps,
                steps.splitNodes, steps.leafNodes, steps.objects the work of
                a ray, each in its mode; cells.R, G, B, A the cells
  Both say how they were made, down to the command that makes them again.

Examples:
  planetree render
      a still life made in code, as render.png
  planetree render bunny.obj
      ambient occlusion of a model, as bunny.png
  planetree render bunny.obj --mode heat -o bunny-heat.png
      how much work each ray is
  planetree render bunny.obj --show-cells 9 -o bunny-cells.png
      the tree around it, nine levels deep
  planetree render bunny.obj --mode depth -o bunny.exr
      how far away everything is
  planetree render scan.ply --up z --size 1920x1080 --samples 32
      a model with z up, larger and smoother
  planetree render room.ply --camera -15,-9,0.5,10,-7,-1,70
      from the eye (-15, -9, 0.5) toward (10, -7, -1), 70 degrees
  planetree render bunny.obj --quiet -o - | display
      the PNG on standard output

Exit status: 0 done, 1 failed, 2 wrong usage.
)";

void addPictureOptions(CLI::App& app, RenderCommand& command) {
  addValue(app, "MODEL", command.model, parsePath,
           "Model to render: PLY, STL, OBJ, OFF, glTF, COLLADA, FBX, 3DS or one of many others; "
           "- is standard input. Without one, a still life made in code")
      ->type_name("");
  addValue(
      app, "-o,--output", command.output, parsePath,
      "Picture to write, replacing an older one: .png or .exr; - is standard output. Otherwise "
      "named after the model, in this folder, or render.png")
      ->type_name("FILE");
  addValue(app, "--format", command.format, parsePictureFormat,
           "Format of the picture; otherwise as the name of the file says, or PNG")
      ->type_name("png|exr");
  addValue(app, "--size", command.size, parseSize, "Width and height in pixels")
      ->type_name("WxH")
      ->default_str(fmt::format("{}x{}", command.size.width, command.size.height));
  addValue(app, "--mode", command.mode, parseMode,
           "What to show: ao (ambient occlusion), normals, depth (near "
           "is bright), or heat (work of each ray)")
      ->type_name("ao|normals|depth|heat")
      ->default_str("ao");
  addWholeNumber(app, "--samples", command.samplesPerPixel, 1, kMaxSamplesPerPixel,
                 "Rays per pixel; in mode ao each that sees a surface sends "
                 "four more. Powers of two are spread best")
      ->default_str(fmt::format("{}", command.samplesPerPixel));
  const auto parseSeed = [](const OptionText& option) {
    return parseWholeNumber(option, 0, std::numeric_limits<std::uint64_t>::max());
  };
  addValue(app, "--seed", command.seed, parseSeed, "Another pattern of samples")
      ->type_name("N")
      ->default_str(fmt::format("{}", command.seed));
}

void addTreeViewOptions(CLI::App& app, RenderCommand& command) {
  const std::string group = "Look at the tree";
  addWholeNumber(app, "--show-cells", command.cellDepth, 1, kMaxTreeDepth,
                 "Draw the cells at this depth of the tree, and the leaves above it, as wires; the "
                 "root is at depth 1")
      ->group(group);
  addWholeNumber(app, "--heat-max", command.heatMax, 1, std::numeric_limits<std::uint32_t>::max(),
                 "Steps per ray that the brightest colour of --mode heat stands for, so that "
                 "pictures can be compared; otherwise 99.5 % of the pixels have fewer")
      ->group(group);
  app.add_flag_callback(
         "--no-legend", [&command] { command.hasLegend = false; },
         "Leave out the legend below the PNG of --mode heat")
      ->group(group);
}

void addViewOptions(CLI::App& app, RenderCommand& command) {
  const std::string view = "View";
  addValue(app, "--camera", command.camera, parseCamera,
           "The eye, the point in the middle of the picture, and the "
           "field of view: six or seven numbers. Otherwise a view of "
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
  render.footer(kFooter);
  addPictureOptions(render, command);
  addViewOptions(render, command);
  addTreeViewOptions(render, command);
  addTreeOptions(render, command.tree);
  addRunOptions(render, command.run);
  addJsonOption(render, command.run);
  return &render;
}

}  // namespace planetree::tool
