#include "picture_metadata.hpp"

#include "usage_error.hpp"

#include <planetree/node/node_layout.hpp>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string>

namespace planetree::tool {

namespace {

template <std::floating_point T>
std::string pointText(const Vec3<T>& point) {
  return fmt::format("{},{},{}", point.x, point.y, point.z);
}

/// The options that make a tree, in the words of the command line: all of them, or those that
/// differ from the defaults.
class TreeArguments {
 public:
  explicit TreeArguments(bool namesDefaults) : namesDefaults_(namesDefaults) {}

  [[nodiscard]] std::string of(const BuildOptions& options) {
    const BuildOptions usual;
    text_.clear();
    add("--leaf-size", options.leafSize, usual.leafSize);
    if (options.depthLimit)
      add("--depth-limit", *options.depthLimit, kMaxTreeDepth + 1);
    addSwitch("--stops-by-cost", options.stopsByCost, usual.stopsByCost);
    add("--traversal-cost", options.cost.traversalCost, usual.cost.traversalCost);
    add("--intersection-cost", options.cost.intersectionCost, usual.cost.intersectionCost);
    add("--face-cost", options.cost.faceCost, usual.cost.faceCost);
    add("--empty-bonus", options.cost.emptyBonus, usual.cost.emptyBonus);
    addSwitch("--allows-empty-cells", options.allowsEmptyCells, usual.allowsEmptyCells);
    addSwitch("--clips-references", options.clipsReferences, usual.clipsReferences);
    add("--planar-rule", planarRuleName(options.planarRule), planarRuleName(usual.planarRule));
    addSwitch("--exact-planes", options.exactPlanes, usual.exactPlanes);
    addSwitch("--retracts-splits", options.retractsSplits, usual.retractsSplits);
    add("--references-per-object", options.referencesPerObject, usual.referencesPerObject);
    return text_;
  }

 private:
  template <class Value>
  void add(std::string_view name, const Value& value, const Value& usual) {
    if (namesDefaults_ || value != usual)
      text_ += fmt::format("{}{} {}", text_.empty() ? "" : " ", name, value);
  }
  void addSwitch(std::string_view name, bool isOn, bool isUsuallyOn) {
    add(name, switchName(isOn), switchName(isUsuallyOn));
  }

  bool namesDefaults_;
  std::string text_;
};

/// How many bytes the UTF-8 character at the start of the text takes; 0 if there is none. RFC 3629:
/// no longer forms than needed, no surrogates, nothing beyond U+10FFFF.
std::size_t utf8Length(std::string_view text) noexcept {
  const auto byte = [text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const unsigned first = byte(0);
  if (first < 0x80)
    return text.empty() ? 0 : 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4)
    return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u)
      return 0;
  }
  const unsigned second = byte(1);
  const bool isOverlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool isBeyond = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
  return isOverlong || isBeyond ? 0 : length;
}

bool isControl(char c) noexcept {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 || byte == 0x7F;
}

/// As $'...' of bash and other shells, which can write every byte.
std::string escapedWord(std::string_view text) {
  std::string word = "$'";
  for (const char c : text) {
    if (c == '\'' || c == '\\')
      word += fmt::format("\\{}", c);
    else if (isControl(c) || static_cast<unsigned char>(c) >= 0x80)
      word += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else
      word += c;
  }
  return word + "'";
}

std::string modelWord(const std::filesystem::path& model) {
  // A name that begins with a dash would be read as an option.
  const std::string name = model.string();
  return shellWord(name.starts_with('-') ? "./" + name : name);
}

std::string treeText(const TreeStatistics& statistics) {
  return fmt::format(
      "{} split nodes, {} leaves ({} empty), depth {}, {} references, largest leaf {}, SAH cost "
      "{:.6g}, {} bytes",
      statistics.splitNodeCount, statistics.leafNodeCount, statistics.emptyLeafCount,
      statistics.depth, statistics.referenceCount, statistics.largestLeaf, statistics.sahCost,
      statistics.bytes);
}

std::string rangeText(render::RenderMode mode, const render::ValueRange& range) {
  const char* const form =
      mode == render::RenderMode::Heat
          ? "black is {:.6g}, pale yellow {:.6g} split nodes visited and objects tested per ray; "
            "pixels: min {:.6g}, mean {:.6g}, max {:.6g}"
          : "the darkest grey is {:.6g}, white {:.6g} from the eye; pixels: min {:.6g}, mean "
            "{:.6g}, max {:.6g}";
  return fmt::format(fmt::runtime(form), range.darkest, range.brightest, range.lowest, range.mean,
                     range.highest);
}

std::string cameraMeaning(const PicturePlan& plan) {
  if (const auto& view = plan.view) {
    return fmt::format("eye {}, look {}, u {}, v {}", pointText(view->eye), pointText(view->look),
                       pointText(view->u), pointText(view->v));
  }
  const render::Camera& camera = plan.camera;
  return fmt::format("eye {}, at {}, up {}, fov {}", pointText(camera.eye), pointText(camera.at),
                     pointText(camera.up), camera.fovDegrees);
}

/// What `--samples` or the options of a grid say.
std::string samplesText(const FinishedPicture& picture) {
  const RenderCommand& command = picture.command;
  std::string text;
  if (picture.plan.mode != render::RenderMode::Whitted) {
    text = fmt::format(" --samples {}", command.samplesPerPixel.value_or(kUsualSamplesPerPixel));
  } else {
    const WhittedOptions& options = command.whitted;
    text = fmt::format(" --supersampling {} --threshold {} --ray-depth {}",
                       options.supersampling.value_or(kUsualSupersampling),
                       options.threshold.value_or(kUsualThreshold),
                       options.rayDepth.value_or(render::WhittedSettings{}.depthLimit));
    if (!options.hasShadows)
      text += " --no-shadows";
    if (options.background) {
      std::string names;
      for (const std::filesystem::path& image : *options.background)
        names += (names.empty() ? "" : ",") + image.string();
      text += " --background " + shellWord(names);
    }
  }
  if (command.cullsBackFaces)
    text += " --culls-back-faces";
  return text + (command.isFlat ? " --flat" : "");
}

std::string samplesMeaning(const render::RenderSettings& settings) {
  if (!settings.grid)
    return fmt::format("{}", settings.samplesPerPixel);
  const render::SampleGrid& grid = *settings.grid;
  if (!grid.threshold || grid.side == 1)
    return fmt::format("{} x {}", grid.side, grid.side);
  return fmt::format("1, or {} x {} where neighbours differ by more than {}", grid.side, grid.side,
                     *grid.threshold);
}

/// The time that the environment gives, if it gives one.
std::optional<std::string> creationTime() {
  const char* const text = std::getenv("SOURCE_DATE_EPOCH");
  if (text == nullptr)
    return std::nullopt;
  constexpr std::uint64_t kEndOfYear9999 = 253'402'300'799;
  const auto seconds = static_cast<std::time_t>(
      parseWholeNumber({.name = "SOURCE_DATE_EPOCH", .text = text}, 0, kEndOfYear9999));
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(seconds));
}

void addCreationTime(render::Metadata& metadata) {
  if (const auto time = creationTime())
    metadata.push_back({"Creation Time", *time});
}

/// What is looked at and how, in the words of all commands that draw.
std::string viewArguments(const FinishedPicture& picture) {
  const RenderCommand& command = picture.command;
  std::string text = command.model ? " " + modelWord(*command.model) : "";
  const PicturePlan& plan = picture.plan;
  text += fmt::format(" --mode {} --size {}x{}{} --seed {}", modeName(plan.mode), plan.size.width,
                      plan.size.height, samplesText(picture), command.seed);
  if (!plan.view)
    text += " --camera " + cameraText(plan.camera);
  if (command.up == render::UpAxis::Z)
    text += " --up z";
  if (command.cellDepth)
    text += fmt::format(" --show-cells {}", *command.cellDepth);
  return text;
}

/// What does not depend on the tree.
render::Metadata commonMetadata(const FinishedPicture& picture, const std::string& commandText) {
  const RenderCommand& command = picture.command;
  const Subject& subject = picture.subject;
  const PicturePlan& plan = picture.plan;
  return {
      {"Software", "planetree " PLANETREE_VERSION},
      {"Command", commandText},
      {"Model", isPlainText(subject.name) ? subject.name : shellWord(subject.name)},
      {command.model && !subject.isScene() ? "Triangles" : "Objects",
       fmt::format("{}", subject.report.objectCount)},
      {"Skipped", fmt::format("{}", subject.report.skippedCount)},
      {"Mode", std::string(modeName(plan.mode))},
      {"Samples", samplesMeaning(renderSettings(command, subject, plan))},
      {"Seed", fmt::format("{}", command.seed)},
      {"Camera", cameraMeaning(plan)},
  };
}

}  // namespace

bool isPlainText(std::string_view text) noexcept {
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    if (length == 0 || isControl(text.front()))
      return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string shellWord(std::string_view text) {
  constexpr std::string_view kHarmless =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=.,:/@%";
  if (!text.empty() && text.find_first_not_of(kHarmless) == std::string_view::npos)
    return std::string(text);
  if (!isPlainText(text))
    return escapedWord(text);
  std::string word = "'";
  for (const char c : text)
    word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string reproducingCommand(const FinishedPicture& picture) {
  const RenderCommand& command = picture.command;
  std::string text = "planetree render" + viewArguments(picture);
  if (const auto& crop = command.crop)
    text +=
        fmt::format(" --crop {},{},{},{}", crop->x, crop->y, crop->size.width, crop->size.height);
  if (command.heatMax)
    text += fmt::format(" --heat-max {}", *command.heatMax);
  if (!command.hasLegend)
    text += " --no-legend";
  if (const std::string tree = TreeArguments(false).of(picture.subject.options); !tree.empty())
    text += " " + tree;
  return text;
}

render::Metadata pictureMetadata(const FinishedPicture& picture) {
  render::Metadata metadata = commonMetadata(picture, reproducingCommand(picture));
  metadata.push_back({"Tree Options", TreeArguments(true).of(picture.subject.options)});
  metadata.push_back({"Tree", treeText(picture.subject.statistics)});
  if (picture.rendering.range)
    metadata.push_back({"Range", rangeText(picture.plan.mode, *picture.rendering.range)});
  if (!picture.rendering.isComplete)
    metadata.push_back(
        {"Done", fmt::format("{:.4g} % of the samples", 100.0 * picture.rendering.done)});
  addCreationTime(metadata);
  return metadata;
}

render::Metadata sheetMetadata(const FinishedPicture& picture, const std::vector<SheetTree>& trees,
                               const render::ValueRange& heatRange, std::string_view arguments) {
  render::Metadata metadata = commonMetadata(
      picture, fmt::format("planetree compare{}{}", viewArguments(picture), arguments));
  for (const auto& [preset, subject] : trees) {
    metadata.push_back({"Tree Options of " + preset, TreeArguments(true).of(subject.options)});
    metadata.push_back({"Tree of " + preset, treeText(subject.statistics)});
  }
  metadata.push_back({"Range", rangeText(render::RenderMode::Heat, heatRange)});
  addCreationTime(metadata);
  return metadata;
}

}  // namespace planetree::tool
