#include "render_options.hpp"

#include <planetree/node/node_layout.hpp>

#include <fmt/format.h>

#include <limits>
#include <string>

namespace planetree::tool {

namespace {

constexpr std::uint64_t kMaxSamplesPerPixel = 65536;
constexpr std::uint64_t kMaxRayDepth = 64;
constexpr std::uint64_t kMaxSupersampling = 64;

constexpr const char* kTreeViewGroup = "Look at the tree";

constexpr const char* kFooter = R"(Pictures:
  PNG           what a screen shows. Heat has a legend below it: the file is
                higher than --size says, and the picture itself is not
  EXR           numbers. R, G, B, A is the picture in linear light, A the part
                with a surface, in mode whitted all; Z the depth, N.X, N.Y,
                N.Z the normal, albedo.R, G, B the albedo, steps,
                steps.splitNodes, steps.leafNodes, steps.objects the work of a
                ray, each in its mode, and the first three in mode whitted,
                too; cells.R, G, B, A the cells
  Both say how they were made, down to the command that makes them again.

Ctrl-C while it renders writes the picture as far as it is; a second one ends
at once.

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
  planetree render spheres.ray --size 1200 --preview 5
      a scene with its materials and lights; the file is there early, and gets
      better every five seconds
  planetree render spheres.ray --crop 300,200,64,64 --supersampling 16
      a small part of the same picture, in pixels, smoother
  planetree render bunny.obj --quiet -o - | display
      the PNG on standard output

Exit status: 0 done, 1 failed, 2 wrong usage.
)";

void addPictureOptions(CLI::App& app, RenderCommand& command) {
  addSubjectArgument(app, command, "render");
  addValue(
      app, "-o,--output", command.output, parsePath,
      "Picture to write, replacing an older one: .png or .exr; - is standard output. Otherwise "
      "named after the model, in this folder, or render.png")
      ->type_name("FILE");
  addValue(app, "--format", command.format, parsePictureFormat,
           "Format of the picture; otherwise as the name of the file says, or PNG")
      ->type_name("png|exr");
  addValue(app, "--size", command.size, parseSize,
           "Width and height in pixels. With the width alone the picture is shaped like the view "
           "of the scene, or like 4:3")
      ->type_name("WxH")
      ->default_str(fmt::format("{}", command.size.width));
  addValue(app, "--crop", command.crop, parseCrop,
           "Render a part of the picture alone: its upper left corner, width and height in pixels")
      ->type_name("X,Y,W,H");
}

void addHeatOptions(CLI::App& app, RenderCommand& command) {
  addWholeNumber(app, "--heat-max", command.heatMax, 1, std::numeric_limits<std::uint32_t>::max(),
                 "Steps per ray that the brightest colour of --mode heat stands for, so that "
                 "pictures can be compared; otherwise 99.5 % of the pixels have fewer")
      ->group(kTreeViewGroup);
  app.add_flag_callback(
         "--no-legend", [&command] { command.hasLegend = false; },
         "Leave out the legend below the PNG of --mode heat")
      ->group(kTreeViewGroup);
}

void addWhileOptions(CLI::App& app, RenderCommand& command) {
  addValue(app, "--preview", command.previewSeconds, parseSeconds,
           "Save the picture as far as it is, again and again after this time")
      ->type_name("SECONDS")
      ->group("Run");
  app.add_flag("--stats", command.showsTimes,
               "Tell how much of the time went into reading, building, tracing, shading, writing")
      ->group("Run");
}

}  // namespace

void addSubjectArgument(CLI::App& app, RenderCommand& command, const std::string& verb) {
  addValue(
      app, "MODEL", command.model, parsePath,
      fmt::format(
          "Scene to {} (.ray or .json), or model: PLY, STL, OBJ, OFF, glTF, COLLADA, "
          "FBX, 3DS or one of many others; - is a model from standard input. Without one, a still "
          "life made in code",
          verb))
      ->type_name("");
}

void addModeOption(CLI::App& app, RenderCommand& command) {
  addValue(app, "--mode", command.mode, parseMode,
           "What to show: whitted (materials and lights, with mirrors, glass and shadows), ao "
           "(ambient occlusion), normals, depth (near is bright), albedo (colours without light), "
           "or heat (work of each ray). Otherwise whitted for what has lights, and ao")
      ->type_name("whitted|ao|normals|depth|albedo|heat");
}

void addSampleOptions(CLI::App& app, RenderCommand& command) {
  addWholeNumber(app, "--samples", command.samplesPerPixel, 1, kMaxSamplesPerPixel,
                 "Rays per pixel, but not in mode whitted; in mode ao each that sees a surface "
                 "sends four more. Powers of two are spread best")
      ->default_str(fmt::format("{}", kUsualSamplesPerPixel));
  const auto parseSeed = [](const OptionText& option) {
    return parseWholeNumber(option, 0, std::numeric_limits<std::uint64_t>::max());
  };
  addValue(app, "--seed", command.seed, parseSeed, "Another pattern of samples")
      ->type_name("N")
      ->default_str(fmt::format("{}", command.seed));
}

void addWhittedOptions(CLI::App& app, RenderCommand& command) {
  const std::string group = "Materials and lights";
  WhittedOptions& options = command.whitted;
  addWholeNumber(app, "--ray-depth", options.rayDepth, 0, kMaxRayDepth,
                 "How often a ray is mirrored or refracted")
      ->default_str(fmt::format("{}", render::WhittedSettings{}.depthLimit))
      ->group(group);
  addWholeNumber(
      app, "--supersampling", options.supersampling, 1, kMaxSupersampling,
      "Take N x N rays in each pixel that differs from a neighbour; 1 is one ray a pixel")
      ->default_str(fmt::format("{}", kUsualSupersampling))
      ->group(group);
  addValue(app, "--threshold", options.threshold, parseThreshold,
           "By how much it must differ in red, green or blue, from 0 to 1; 0 is N x N rays in "
           "every pixel")
      ->type_name("X")
      ->default_str(fmt::format("{}", kUsualThreshold))
      ->group(group);
  app.add_flag_callback(
         "--no-shadows", [&options] { options.hasShadows = false; }, "Light passes all surfaces")
      ->group(group);
  app.add_flag("--flat", command.isFlat,
               "Leave out the normals that meshes have at their corners, also in mode normals")
      ->group(group);
  addValue(app, "--background", options.background, parseCubeMap,
           "What is seen behind everything: six images of a cube map, posx, negx, posy, negy, posz "
           "and negz")
      ->type_name("FILE,FILE,FILE,FILE,FILE,FILE")
      ->group(group);
}

void addCellsOption(CLI::App& app, RenderCommand& command) {
  addWholeNumber(app, "--show-cells", command.cellDepth, 1, kMaxTreeDepth,
                 "Draw the cells at this depth of the tree, and the leaves above it, as wires; the "
                 "root is at depth 1")
      ->group(kTreeViewGroup);
}

void addViewOptions(CLI::App& app, RenderCommand& command) {
  const std::string view = "View";
  addValue(app, "--camera", command.camera, parseCamera,
           "The eye, the point in the middle of the picture, and the "
           "field of view: six or seven numbers. Otherwise the camera of "
           "the scene, or a view of the whole model, from its right and above")
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

CLI::App* addRenderCommand(CLI::App& app, RenderCommand& command) {
  CLI::App& render =
      *app.add_subcommand("render", "Render a scene, a model, or a still life made in code");
  render.footer(kFooter);
  addPictureOptions(render, command);
  addModeOption(render, command);
  addSampleOptions(render, command);
  addViewOptions(render, command);
  addWhittedOptions(render, command);
  addCullingFlag(render, command.cullsBackFaces);
  addCellsOption(render, command);
  addHeatOptions(render, command);
  addTreeOptions(render, command.tree);
  addRunOptions(render, command.run);
  addWhileOptions(render, command);
  addJsonOption(render, command.run);
  return &render;
}

}  // namespace planetree::tool
