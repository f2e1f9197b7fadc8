#include "compare_command.hpp"

#include "compare/compare_page.hpp"
#include "compare/compare_presets.hpp"
#include "compare/contact_sheet.hpp"
#include "exit_status.hpp"
#include "instruments/print_page.hpp"
#include "json_text.hpp"
#include "model.hpp"
#include "output_file.hpp"
#include "progress_line.hpp"
#include "talk.hpp"
#include "usage_error.hpp"

#include "render/file/encode_png.hpp"
#include "render/render_image.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <system_error>
#include <utility>

namespace planetree::tool {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxSamplesPerPixel = 65536;
constexpr std::uint64_t kMaxRoundCount = 1000;
constexpr std::uint64_t kMaxRayPictureSize = 4096;

constexpr const char* kUsualPresets = "fast,balanced,high";

constexpr const char* kFooter =
    R"(The trees answer the same rays: a picture of the whole model (primary), from
each of its hits a short one (ao), and rays from anywhere to anywhere in its
bounds (random), all in batches. Presets take turns in every round, and the
best of the rounds counts. The SAH cost is counted by the costs of the preset
balanced for all of them.

Examples:
  planetree compare bunny.obj
      a table of fast, balanced and high
  planetree compare bunny.obj --presets fast,textbook -o bunny-presets.png
      the two, and a sheet of pictures with the work of each ray
  planetree compare bunny.obj --json | jq '.presets[].build_seconds'
      one figure of each for a script

Exit status: 0 done, 1 failed, 2 wrong usage.
)";

std::vector<Preset> parsePresets(const OptionText& option) {
  std::vector<Preset> chosen;
  std::string_view rest = option.text;
  for (bool isLast = false; !isLast;) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view name = rest.substr(0, comma);
    isLast = comma == rest.size();
    rest.remove_prefix(isLast ? comma : comma + 1);
    static_cast<void>(parsePreset({option.name, name}));  // refuses what is none
    const auto preset = std::ranges::find(presets(), name, &Preset::first);
    if (std::ranges::find(chosen, name, &Preset::first) != chosen.end()) {
      throw UsageError(fmt::format("{} {}: {} is there twice", option.name, option.text, name),
                       "Name each preset once.");
    }
    chosen.push_back(*preset);
  }
  return chosen;
}

void checkOutput(const CompareCommand& command) {
  if (!command.output) {
    if (command.heatMax)
      throw UsageError("--heat-max: there is no picture to colour", "Add -o FILE.png.");
    return;
  }
  const fs::path& output = *command.output;
  if (output == kStandardOutput) {
    if (::isatty(STDOUT_FILENO) != 0) {
      throw UsageError("-o -: standard output is a terminal",
                       "Send the picture to a file or a program: -o - > presets.png.");
    }
  } else if (lowerCaseExtension(output) != ".png") {
    throw UsageError(fmt::format("-o {}: contact sheets are PNG files", output.string()),
                     "Give a name that ends in .png.");
  }
  std::error_code missing;
  if (fs::equivalent(command.model, output, missing)) {
    throw UsageError(fmt::format("-o {}: that is the model", output.string()),
                     "Give the picture another name.");
  }
  checkIsWritable(output);
  // Two pictures in each row.
  const std::uint64_t pixelCount = 2 * command.presets.size() * command.size.pixelCount();
  if (pixelCount > kMaxPixelCount) {
    throw UsageError(
        "--size: the sheet would be too large",
        fmt::format("Ask for smaller pictures: {} pixels in all are the most.", kMaxPixelCount));
  }
}

render::Camera cameraFor(const Model<float>& model, render::UpAxis up, double aspect) {
  return render::frameCamera(render::visiblePoints(model.mesh.view()), {.up = up, .aspect = aspect})
      .value_or(render::Camera{});
}

void buildAll(const CompareCommand& command, const Model<float>& model, const Talk& talk,
              PresetComparison& comparison) {
  ProgressLine progress("building trees", talk.showsProgress());
  std::vector<std::string> names;
  for (const Preset& preset : command.presets)
    names.emplace_back(preset.first);
  comparison.build(names, [&](std::size_t i) {
    BuildOptions options = command.presets[i].second;
    options.threadCount = command.run.threadCount;
    BuildControl control = buildControl(command.run);
    control.onProgress = [&](const BuildProgress& build) {
      progress.update((static_cast<double>(i) + build.done) / static_cast<double>(names.size()));
    };
    auto tree = buildTree(model.mesh.view(), options, control);
    requireHittable(tree.report(), model.name);
    return tree;
  });
}

render::Rendering rendered(const CompareCommand& command, const KdTree<Face<float>>& tree,
                           const render::Camera& camera, render::RenderMode mode) {
  return renderImage(render::TreeTracer<Face<float>>(tree),
                     {.size = command.size,
                      .camera = camera,
                      .mode = mode,
                      .samplesPerPixel = command.samplesPerPixel,
                      .threadCount = command.run.threadCount});
}

void writeSheet(const CompareCommand& command, const Model<float>& model,
                const ComparedModel& compared, const std::vector<PresetFigures>& figures,
                const Talk& talk) {
  const double aspect = static_cast<double>(command.size.width) / command.size.height;
  const render::Camera camera = cameraFor(model, command.up, aspect);
  std::vector<SheetRow> rows;
  {
    ProgressLine progress("rendering", talk.showsProgress());
    for (const PresetFigures& preset : figures) {
      rows.push_back(
          {.title = preset.name,
           .figures = figuresLine(compared, preset),
           .picture = rendered(command, preset.tree, camera, render::RenderMode::AmbientOcclusion),
           .heat = rendered(command, preset.tree, camera, render::RenderMode::Heat)});
      progress.update(static_cast<double>(rows.size()) / static_cast<double>(figures.size()));
    }
  }
  const std::string name = fs::path(compared.name).filename().string();
  const auto heatMax = command.heatMax ? std::optional<double>(*command.heatMax) : std::nullopt;
  const render::Image sheet = contactSheet(
      fmt::format("{}: {}", name, counted(compared.triangleCount, "triangle")), rows, heatMax);
  const std::vector<std::byte> bytes = encodePng(sheet, {});
  writeFile(*command.output, bytes);
  talk.say(
      fmt::format("wrote {} ({} x {}, {})",
                  command.output == kStandardOutput ? "standard output" : command.output->string(),
                  sheet.size.width, sheet.size.height, byteText(bytes.size())));
}

Json compareJson(const CompareCommand& command, const Json& mesh, const ComparedModel& model,
                 const std::vector<PresetFigures>& figures) {
  return {{"model", command.model.string()},
          {"mesh", mesh},
          {"picture", command.output ? Json(command.output->string()) : Json(nullptr)},
          {"round_count", command.roundCount},
          {"primary_ray_count", model.primaryRayCount},
          {"ao_ray_count", model.aoRayCount},
          {"random_ray_count", model.randomRayCount},
          {"presets", presetsJson(model, figures)}};
}

}  // namespace

CLI::App* addCompareCommand(CLI::App& app, CompareCommand& command) {
  CLI::App& compare =
      *app.add_subcommand("compare", "Show side by side what presets make of a model");
  compare.footer(kFooter);
  command.presets = parsePresets({"--presets", kUsualPresets});
  addValue(compare, "MODEL", command.model, parsePath, "Model to build; - is standard input")
      ->required()
      ->type_name("");
  addValue(compare, "--presets", command.presets, parsePresets,
           "Presets to compare, with commas between: fast, balanced, high, textbook")
      ->type_name("NAMES")
      ->default_str(kUsualPresets);
  addWholeNumber(compare, "--rounds", command.roundCount, 1, kMaxRoundCount,
                 "How often everything is measured; the best counts")
      ->default_str(fmt::format("{}", command.roundCount));
  addWholeNumber(compare, "--ray-picture", command.rayPictureSize, 1, kMaxRayPictureSize,
                 "Pixels along each side of the picture that the measured rays come from")
      ->default_str(fmt::format("{}", command.rayPictureSize));
  const std::string sheet = "Contact sheet";
  addValue(compare, "-o,--output", command.output, parsePath,
           "Draw a picture and the heat of each preset into this PNG file; - is standard output, "
           "and then the table is left out")
      ->type_name("FILE");
  const auto parseSheetSize = [](const OptionText& option) {
    const SizeOption size = parseSize(option);
    const std::uint32_t usualHeight = std::max(1u, size.width / 4 * 3);
    return render::ImageSize{size.width, size.height.value_or(usualHeight)};
  };
  addValue(compare, "--size", command.size, parseSheetSize,
           "Width and height of each picture in pixels")
      ->type_name("WxH")
      ->default_str(fmt::format("{}x{}", command.size.width, command.size.height))
      ->group(sheet);
  addWholeNumber(compare, "--samples", command.samplesPerPixel, 1, kMaxSamplesPerPixel,
                 "Rays per pixel")
      ->default_str(fmt::format("{}", command.samplesPerPixel))
      ->group(sheet);
  addWholeNumber(compare, "--heat-max", command.heatMax, 1,
                 std::numeric_limits<std::uint32_t>::max(),
                 "Steps per ray that the brightest colour of the heat stands for; otherwise as "
                 "many as the presets need")
      ->group(sheet);
  addValue(compare, "--up", command.up, parseUpAxis, "Which way is up in the model")
      ->type_name("y|z")
      ->default_str("y")
      ->group(sheet);
  addRunOptions(compare, command.run);
  addJsonOption(compare, command.run);
  return &compare;
}

int runCompareCommand(const CompareCommand& command) {
  checkOutput(command);
  const bool isSheetData = command.output && *command.output == kStandardOutput;
  const Talk talk(command.run.isQuiet || (isSheetData && command.run.isJson));
  // What the table says needs no line besides.
  const Model<float> model =
      readModel<float>(command.model, Talk::ofProgress(talk.showsProgress()));

  PresetComparison comparison(
      {.threadCount = command.run.threadCount, .roundCount = command.roundCount});
  buildAll(command, model, talk, comparison);
  const ComparisonRays rays = makeComparisonRays(
      comparison.figures().front().tree, cameraFor(model, command.up, 1.0), command.rayPictureSize);
  {
    ProgressLine progress("tracing", talk.showsProgress());
    comparison.trace(rays, [&progress](double done) { progress.update(done); });
  }
  const std::vector<PresetFigures>& figures = comparison.figures();
  const ComparedModel compared{.name = model.name,
                               .triangleCount = model.mesh.faces.size(),
                               .primaryRayCount = rays.primary.size(),
                               .aoRayCount = rays.ao.size(),
                               .randomRayCount = rays.random.size()};
  if (command.output)
    writeSheet(command, model, compared, figures, talk);
  if (command.run.isJson) {
    const Json mesh =
        meshJson({.faceCount = model.mesh.faces.size(), .vertexCount = model.mesh.positions.size()},
                 model.report);
    printJson(compareJson(command, mesh, compared, figures), isSheetData);
  } else if (!isSheetData) {
    printPage(comparePage(compared, figures));
  }
  return kDone;
}

}  // namespace planetree::tool
