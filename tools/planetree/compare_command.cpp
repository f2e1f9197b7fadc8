#include "compare_command.hpp"

#include "compare/compare_page.hpp"
#include "compare/compare_presets.hpp"
#include "compare/contact_sheet.hpp"
#include "exit_status.hpp"
#include "instruments/print_page.hpp"
#include "json_text.hpp"
#include "output_file.hpp"
#include "picture_file.hpp"
#include "picture_metadata.hpp"
#include "picture_plan.hpp"
#include "progress_line.hpp"
#include "ray_files/byte_source.hpp"
#include "render_options.hpp"
#include "subject.hpp"
#include "talk.hpp"
#include "usage_error.hpp"

#include "render/file/encode_png.hpp"
#include "render/render_image.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace planetree::tool {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxRoundCount = 1000;
constexpr std::uint64_t kMaxRayPictureSize = 4096;

constexpr std::uint32_t kUsualWidth = 480;
constexpr const char* kUsualPresets = "fast,balanced,high";

constexpr const char* kFooter =
    R"(The trees answer the same rays: a picture of the subject (primary), from each
of its hits a short one (ao), and rays from anywhere to anywhere in its bounds
(random), all in batches. Presets take turns in every round, and the
best of the rounds counts. The SAH cost is counted by the costs of the preset
balanced for all of them.

Examples:
  planetree compare bunny.obj
      a table of fast, balanced and high
  planetree compare bunny.obj --presets fast,textbook -o bunny-presets.png
      the two, and a sheet of pictures with the work of each ray
  planetree compare spheres.ray -o spheres-presets.png
      a scene with its materials and lights
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

bool hasSheet(const CompareCommand& command) {
  return command.picture.output.has_value();
}

/// Two pictures in each row.
void checkSheetSize(const CompareCommand& command, const render::ImageSize& size) {
  if (2 * command.presets.size() * size.pixelCount() > kMaxPixelCount) {
    throw UsageError(
        "--size: the sheet would be too large",
        fmt::format("Ask for smaller pictures: {} pixels in all are the most.", kMaxPixelCount));
  }
}

void checkOutput(const CompareCommand& command) {
  const RenderCommand& picture = command.picture;
  if (!picture.output) {
    if (picture.heatMax)
      throw UsageError("--heat-max: there is no picture to colour", "Add -o FILE.png.");
    return;
  }
  const fs::path& output = *picture.output;
  if (!isStandardOutput(picture) && lowerCaseExtension(output) != ".png") {
    throw UsageError(fmt::format("-o {}: contact sheets are PNG files", output.string()),
                     "Give a name that ends in .png.");
  }
  checkOutputName(picture);
  checkIsWritable(output);
  if (picture.size.height)
    checkSheetSize(command, {picture.size.width, *picture.size.height});
}

/// The picture of a row without what is about the heat beside it.
RenderCommand pictureWithoutHeat(const CompareCommand& command) {
  RenderCommand picture = command.picture;
  picture.samplesPerPixel.reset();
  picture.heatMax.reset();
  return picture;
}

/// The pictures of a row, once it is known what they show.
struct RowPlan {
  RenderCommand picture;
  PicturePlan plan;
  render::RenderSettings heat;
};

RowPlan planRow(const CompareCommand& command, const Subject& subject) {
  RowPlan row{.picture = pictureWithoutHeat(command), .plan = {}, .heat = {}};
  row.plan = planPicture(row.picture, subject);
  if (row.plan.mode != render::RenderMode::Whitted)
    row.picture.samplesPerPixel = command.picture.samplesPerPixel;
  RenderCommand heat = command.picture;
  heat.cellDepth.reset();
  PicturePlan heatPlan = row.plan;
  heatPlan.mode = render::RenderMode::Heat;
  row.heat = renderSettings(heat, subject, heatPlan);
  return row;
}

render::PinholeCamera cameraOf(const PicturePlan& plan) {
  if (plan.view)
    return render::PinholeCamera(*plan.view);
  return {plan.camera, static_cast<double>(plan.size.width) / plan.size.height};
}

Subject buildPreset(const CompareCommand& command, const SubjectSource& source,
                    const BuildOptions& preset,
                    const std::function<void(const BuildProgress&)>& onProgress) {
  BuildOptions options = preset;
  options.threadCount = command.picture.run.threadCount;
  BuildControl control = buildControl(command.picture.run);
  control.onProgress = onProgress;
  return source.build({.options = options, .control = control});
}

/// What the preset balanced takes an object for, which depends on what else is in the tree: a tree
/// of one leaf costs what its objects cost.
double objectCost(const CompareCommand& command, const SubjectSource& source) {
  BuildOptions options;
  options.depthLimit = 1;
  const TreeStatistics leaf = buildPreset(command, source, options, {}).statistics;
  const auto count = static_cast<double>(std::max<std::uint64_t>(leaf.referenceCount, 1));
  const double between = (options.cost.faceCost + options.cost.intersectionCost) / 2.0;
  return leaf.sahCost / count < between ? options.cost.faceCost : options.cost.intersectionCost;
}

void buildAll(const CompareCommand& command, const SubjectSource& source, const Talk& talk,
              PresetComparison& comparison) {
  ProgressLine progress("building trees", talk.showsProgress());
  std::vector<std::string> names;
  for (const Preset& preset : command.presets)
    names.emplace_back(preset.first);
  comparison.build(names, [&](std::size_t i) {
    return buildPreset(command, source, command.presets[i].second,
                       [&, i](const BuildProgress& build) {
                         progress.update((static_cast<double>(i) + build.done) /
                                         static_cast<double>(names.size()));
                       });
  });
}

/// What makes the sheet again, beside the view.
std::string sheetArguments(const CompareCommand& command, const RowPlan& row) {
  std::string names;
  for (const Preset& preset : command.presets)
    names += fmt::format("{}{}", names.empty() ? "" : ",", preset.first);
  const RenderCommand& picture = command.picture;
  std::string text;
  // In other modes the view has them.
  if (row.plan.mode == render::RenderMode::Whitted)
    text += fmt::format(" --samples {}", row.heat.samplesPerPixel);
  if (picture.heatMax)
    text += fmt::format(" --heat-max {}", *picture.heatMax);
  return text + fmt::format(" --presets {} --rounds {} --ray-picture {} -o {}", names,
                            command.roundCount, command.rayPictureSize,
                            shellWord(picture.output->string()));
}

void writeSheet(const CompareCommand& command, const ComparedModel& compared,
                const std::vector<PresetFigures>& figures, const Talk& talk) {
  std::vector<SheetRow> rows;
  std::vector<SheetTree> trees;
  std::optional<RowPlan> first;
  {
    ProgressLine progress("rendering", talk.showsProgress());
    for (const PresetFigures& preset : figures) {
      const Subject& subject = preset.subject;
      const RowPlan row = planRow(command, subject);
      rows.push_back(
          {.title = preset.name,
           .figures = figuresLine(compared, preset),
           .picture = renderImage(*subject.tracer, renderSettings(row.picture, subject, row.plan)),
           .heat = renderImage(*subject.tracer, row.heat)});
      trees.push_back({preset.name, subject});
      if (!first)
        first = row;
      progress.update(static_cast<double>(rows.size()) / static_cast<double>(figures.size()));
    }
  }
  const std::string name = fs::path(compared.name).filename().string();
  const auto heatMax =
      command.picture.heatMax ? std::optional<double>(*command.picture.heatMax) : std::nullopt;
  const ContactSheet sheet =
      contactSheet(fmt::format("{}: {}", name, counted(compared.objectCount, compared.objectName)),
                   rows, heatMax);
  const FinishedPicture picture{first->picture, figures.front().subject, first->plan,
                                rows.front().picture};
  const std::vector<std::byte> bytes = encodePng(
      sheet.image, sheetMetadata(picture, trees, sheet.range, sheetArguments(command, *first)));
  writeFile(*command.picture.output, bytes);
  talk.say(fmt::format(
      "wrote {} ({} x {}, {})",
      isStandardOutput(command.picture) ? "standard output" : command.picture.output->string(),
      sheet.image.size.width, sheet.image.size.height, byteText(bytes.size())));
}

std::string displayName(const RenderCommand& picture, const Subject& subject) {
  if (!picture.model)
    return subject.name;
  return *picture.model == kStandardInput ? "standard input" : picture.model->string();
}

Json compareJson(const CompareCommand& command, const ComparedModel& model,
                 const std::vector<PresetFigures>& figures) {
  const auto pathJson = [](const std::optional<fs::path>& path) {
    return path ? Json(path->string()) : Json(nullptr);
  };
  const Subject& subject = figures.front().subject;
  return {{"model", pathJson(command.picture.model)},
          {"mesh", subject.mesh},
          {"scene", subject.materials},
          {"picture", pathJson(command.picture.output)},
          {"round_count", command.roundCount},
          {"primary_ray_count", model.primaryRayCount},
          {"ao_ray_count", model.aoRayCount},
          {"random_ray_count", model.randomRayCount},
          {"presets", presetsJson(model, figures)}};
}

}  // namespace

CLI::App* addCompareCommand(CLI::App& app, CompareCommand& command) {
  CLI::App& compare =
      *app.add_subcommand("compare", "Show side by side what presets make of a scene or a model");
  compare.footer(kFooter);
  command.presets = parsePresets({"--presets", kUsualPresets});
  addSubjectArgument(compare, command.picture, "build");
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
  RenderCommand& picture = command.picture;
  picture.size.width = kUsualWidth;
  addValue(compare, "-o,--output", picture.output, parsePath,
           "Draw a picture and the heat of each preset into this PNG file; - is standard output, "
           "and then the table is left out")
      ->type_name("FILE");
  const std::string sheet = "Contact sheet";
  addValue(compare, "--size", picture.size, parseSize,
           "Width and height of each picture in pixels. With the width alone it is shaped like the "
           "view of the scene, or like 4:3")
      ->type_name("WxH")
      ->default_str(fmt::format("{}", picture.size.width))
      ->group(sheet);
  addModeOption(compare, picture);
  addSampleOptions(compare, picture);
  addWholeNumber(compare, "--heat-max", picture.heatMax, 1,
                 std::numeric_limits<std::uint32_t>::max(),
                 "Steps per ray that the brightest colour of the heat stands for; otherwise as "
                 "many as the presets need")
      ->group(sheet);
  addViewOptions(compare, picture);
  addWhittedOptions(compare, picture);
  addCellsOption(compare, picture);
  addRunOptions(compare, picture.run);
  addJsonOption(compare, picture.run);
  return &compare;
}

int runCompareCommand(const CompareCommand& command) {
  checkOutput(command);
  const RenderCommand picture = pictureWithoutHeat(command);
  checkPictureOptions(picture);
  const RunOptions& run = picture.run;
  const bool isSheetData = hasSheet(command) && isStandardOutput(picture);
  const Talk talk(run.isQuiet || (isSheetData && run.isJson));
  // What the table says needs no line besides.
  const SubjectSourcePtr source = readSource(picture, Talk::ofProgress(talk.showsProgress()));

  PresetComparison comparison({.threadCount = run.threadCount,
                               .roundCount = command.roundCount,
                               .objectCost = objectCost(command, *source)});
  buildAll(command, *source, talk, comparison);
  const std::vector<PresetFigures>& figures = comparison.figures();
  for (const PresetFigures& preset : figures)
    checkSheetSize(command, planRow(command, preset.subject).plan.size);
  const Subject& subject = figures.front().subject;
  const ComparisonRays rays = makeComparisonRays(
      *subject.tracer, cameraOf(planRow(command, subject).plan), command.rayPictureSize);
  {
    ProgressLine progress("tracing", talk.showsProgress());
    comparison.trace(rays, [&progress](double done) { progress.update(done); });
  }
  const ComparedModel compared{.name = displayName(picture, subject),
                               .objectName = std::string(source->objectName()),
                               .objectCount = subject.report.objectCount,
                               .primaryRayCount = rays.primary.size(),
                               .aoRayCount = rays.ao.size(),
                               .randomRayCount = rays.random.size()};
  if (hasSheet(command))
    writeSheet(command, compared, figures, talk);
  if (run.isJson) {
    printJson(compareJson(command, compared, figures), isSheetData);
  } else if (!isSheetData) {
    printPage(comparePage(compared, figures));
  }
  return kDone;
}

}  // namespace planetree::tool
