#include "picture_plan.hpp"

#include "option_values.hpp"
#include "picture_file.hpp"
#include "scene_file.hpp"
#include "talk.hpp"
#include "usage_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace planetree::tool {

namespace {

using render::RenderMode;

/// Of pictures whose height nobody has chosen.
constexpr double kUsualAspect = 4.0 / 3.0;

bool shines(const scene::Material& material) noexcept {
  return material.emissive.texture || material.emissive.value != Vec3d{0, 0, 0};
}

/// Whether anything shines in the scene by itself: then Whitted's shading shows it as it was meant.
bool isLit(const scene::SceneDescription& description) noexcept {
  const bool hasLights = !description.pointLights.empty() ||
                         !description.directionalLights.empty() ||
                         description.ambientLight != Vec3d{0, 0, 0};
  return (hasLights && !description.hasDefaultLighting) || description.background ||
         std::ranges::any_of(description.materials, shines);
}

void refuseOutside(bool isGiven, const char* option, const char* reason, const char* mode) {
  if (isGiven) {
    throw UsageError(fmt::format("{}: {}", option, reason),
                     fmt::format("Add --mode {}, or leave it out.", mode));
  }
}

void checkHeatOptions(const RenderCommand& command) {
  if (command.mode == RenderMode::Heat)
    return;
  refuseOutside(command.heatMax.has_value(), "--heat-max", "only --mode heat has such a scale",
                "heat");
  refuseOutside(!command.hasLegend, "--no-legend", "only --mode heat has a legend", "heat");
}

void checkModeOptions(const RenderCommand& command, RenderMode mode) {
  if (mode == RenderMode::Whitted) {
    if (command.samplesPerPixel) {
      throw UsageError("--samples: --mode whitted has a grid of rays in each pixel",
                       "Give --supersampling, the side of the grid.");
    }
    return;
  }
  const WhittedOptions& whitted = command.whitted;
  const char* const reason = "only --mode whitted has it";
  refuseOutside(whitted.rayDepth.has_value(), "--ray-depth", reason, "whitted");
  refuseOutside(whitted.supersampling.has_value(), "--supersampling", reason, "whitted");
  refuseOutside(whitted.threshold.has_value(), "--threshold", reason, "whitted");
  refuseOutside(!whitted.hasShadows, "--no-shadows", reason, "whitted");
  refuseOutside(whitted.background.has_value(), "--background", reason, "whitted");
  if (mode != RenderMode::Normals)
    refuseOutside(command.isFlat, "--flat", "only --mode whitted and normals have it", "whitted");
}

/// The mode of a scene, or of anything else.
RenderMode modeFor(const RenderCommand& command, bool isLitScene) {
  return command.mode.value_or(isLitScene ? RenderMode::Whitted : RenderMode::AmbientOcclusion);
}

/// Whether a scene's own camera takes the picture.
bool usesView(const RenderCommand& command, const std::optional<scene::View>& view) {
  return view.has_value() && !command.camera;
}

render::ImageSize chosenSize(const RenderCommand& command, double aspect) {
  const SizeOption& size = command.size;
  if (size.height)
    return {size.width, *size.height};
  const double height = std::clamp(std::round(size.width / aspect), 1.0, 1e9);
  const std::string text = fmt::format("{}", size.width);
  checkPixelCount({.name = "--size", .text = text}, size.width, static_cast<std::uint64_t>(height));
  return {size.width, static_cast<std::uint32_t>(height)};
}

void checkCrop(const RenderCommand& command, const render::ImageSize& size) {
  if (!command.crop)
    return;
  const render::PixelWindow& crop = *command.crop;
  const auto isWithin = [](std::uint64_t first, std::uint64_t count, std::uint64_t all) {
    return first + count <= all;
  };
  if (isWithin(crop.x, crop.size.width, size.width) &&
      isWithin(crop.y, crop.size.height, size.height))
    return;
  throw UsageError(fmt::format("--crop {},{},{},{}: the picture has {} x {} pixels", crop.x, crop.y,
                               crop.size.width, crop.size.height, size.width, size.height),
                   "Give a part of it, or a larger --size.");
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

render::WhittedSettings whittedSettings(const RenderCommand& command) {
  render::WhittedSettings settings;
  settings.depthLimit = command.whitted.rayDepth.value_or(settings.depthLimit);
  settings.isSmooth = !command.isFlat;
  settings.hasShadows = command.whitted.hasShadows;
  return settings;
}

render::SampleGrid sampleGrid(const RenderCommand& command) {
  render::SampleGrid grid{.side = command.whitted.supersampling.value_or(kUsualSupersampling)};
  const float threshold = command.whitted.threshold.value_or(kUsualThreshold);
  if (threshold > 0.0f)
    grid.threshold = threshold;
  return grid;
}

/// Whether the materials of the subject are needed.
bool wantsScene(const RenderCommand& command) {
  if (!command.model)
    return false;
  return hasSurfaces(*command.model) || command.mode == RenderMode::Whitted ||
         command.mode == RenderMode::Albedo;
}

/// Once it is known what the scene has, and before long work.
void checkOptionsFit(const RenderCommand& command, const scene::SceneDescription& description) {
  checkModeOptions(command, modeFor(command, isLit(description)));
  if (command.fovDegrees && usesView(command, description.view)) {
    throw UsageError("--fov: the scene has a camera", "Give --camera too, or leave out --fov.");
  }
}

/// How a subject without a camera is to be looked at.
render::Framing framing(const RenderCommand& command) {
  render::Framing framing{.up = command.up, .showsBox = command.cellDepth.has_value()};
  const render::ImageSize size = chosenSize(command, kUsualAspect);
  framing.aspect = static_cast<double>(size.width) / size.height;
  if (command.fovDegrees)
    framing.fovDegrees = *command.fovDegrees;
  return framing;
}

}  // namespace

void checkOptionsAgree(const RenderCommand& command) {
  checkOutputName(command);
  checkHeatOptions(command);
  checkPictureOptions(command);
  if (command.previewSeconds && isStandardOutput(command)) {
    throw UsageError("--preview: what was sent to standard output cannot be replaced",
                     "Give -o the name of a file.");
  }
}

void checkPictureOptions(const RenderCommand& command) {
  const bool isScene = wantsScene(command);
  if (command.mode || !isScene)
    checkModeOptions(command, modeFor(command, false));
  if (command.size.height || !isScene)
    checkCrop(command, chosenSize(command, kUsualAspect));
  if (!command.model &&
      (command.mode == RenderMode::Whitted || command.mode == RenderMode::Albedo)) {
    throw UsageError(
        fmt::format("--mode {}: the still life has no materials", modeName(*command.mode)),
        "Give a scene or a MODEL.");
  }
  if (command.fovDegrees && command.camera && command.camera->fovDegrees) {
    throw UsageError("--fov: --camera gives the field of view too",
                     "Leave out --fov, or the seventh number of --camera.");
  }
  if (!command.model && command.up != render::UpAxis::Y) {
    throw UsageError("--up z: the still life has y up", "Give a MODEL, or leave out --up.");
  }
}

SubjectSourcePtr readSource(const RenderCommand& command, const Talk& talk) {
  if (!command.model)
    return makeStillLifeSource(framing(command), talk);
  if (!wantsScene(command))
    return readModelSource(*command.model, framing(command), talk);
  const auto check = [&command](const scene::SceneDescription& description) {
    checkOptionsFit(command, description);
  };
  return readSceneSource(*command.model, framing(command), command.whitted.background, talk, check);
}

PicturePlan planPicture(const RenderCommand& command, const Subject& subject) {
  checkCellDepth(command, subject);
  PicturePlan plan;
  plan.mode = modeFor(command, subject.isScene() && isLit(subject.scene->description()));
  if (usesView(command, subject.view))
    plan.view = subject.view;
  plan.size = chosenSize(command, plan.view ? plan.view->aspectRatio() : kUsualAspect);
  checkCrop(command, plan.size);
  plan.camera = subject.camera;
  plan.camera.up = render::upVector(command.up);
  if (command.camera) {
    plan.camera.eye = command.camera->eye;
    plan.camera.at = command.camera->at;
    plan.camera.fovDegrees = command.camera->fovDegrees.value_or(subject.camera.fovDegrees);
  }
  return plan;
}

render::RenderSettings renderSettings(const RenderCommand& command, const Subject& subject,
                                      const PicturePlan& plan) {
  render::RenderSettings settings;
  settings.size = plan.size;
  settings.camera = plan.camera;
  settings.view = plan.view;
  settings.mode = plan.mode;
  settings.samplesPerPixel = command.samplesPerPixel.value_or(kUsualSamplesPerPixel);
  settings.seed = command.seed;
  if (plan.mode == RenderMode::Whitted)
    settings.grid = sampleGrid(command);
  settings.crop = command.crop;
  settings.threadCount = command.run.threadCount;
  settings.scene = subject.scene.get();
  settings.whitted = whittedSettings(command);
  settings.albedos = subject.albedos;
  settings.hasShadingNormals = subject.isScene() && !command.isFlat;
  settings.heatMax = command.heatMax;
  settings.cellDepth = command.cellDepth;
  settings.hasLayers = chosenFormat(command) == PictureFormat::Exr;
  settings.isProgressive = true;
  return settings;
}

}  // namespace planetree::tool
