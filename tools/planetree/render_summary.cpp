#include "render_summary.hpp"

#include "picture_plan.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace planetree::tool {

namespace {

Json pointJson(const Vec3f& point) {
  return Json::array({point.x, point.y, point.z});
}

Json pointJson(const Vec3d& point) {
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

Json cameraJson(const PicturePlan& plan) {
  if (plan.view) {
    return {{"eye", pointJson(plan.view->eye)},
            {"look", pointJson(plan.view->look)},
            {"u", pointJson(plan.view->u)},
            {"v", pointJson(plan.view->v)}};
  }
  return {{"eye", pointJson(plan.camera.eye)},
          {"at", pointJson(plan.camera.at)},
          {"up", pointJson(plan.camera.up)},
          {"fov", plan.camera.fovDegrees}};
}

Json cropJson(const std::optional<render::PixelWindow>& crop) {
  if (!crop)
    return nullptr;
  return Json::array({crop->x, crop->y, crop->size.width, crop->size.height});
}

Json samplesJson(const render::RenderSettings& settings) {
  return settings.grid ? settings.grid->samplesPerPixel() : settings.samplesPerPixel;
}

Json whittedJson(const render::RenderSettings& settings) {
  if (!settings.grid)
    return nullptr;
  return {{"ray_depth", settings.whitted.depthLimit},
          {"supersampling", settings.grid->side},
          {"threshold", settings.grid->threshold.value_or(0.0f)},
          {"has_shadows", settings.whitted.hasShadows},
          {"is_smooth", settings.whitted.isSmooth}};
}

Json timesJson(const RunTimes& times) {
  return {{"reading_seconds", times.reading},
          {"building_seconds", times.building},
          {"tracing_seconds", times.tracing},
          {"shading_seconds", times.shading},
          {"writing_seconds", times.writing}};
}

}  // namespace

RunTimes runTimes(const FinishedPicture& picture, double writingSeconds) {
  const render::Rendering& rendering = picture.rendering;
  const double busy = rendering.tracingSeconds + rendering.shadingSeconds;
  const double tracingPart = busy > 0.0 ? rendering.tracingSeconds / busy : 0.0;
  return {.reading = picture.subject.readingSeconds,
          .building = picture.subject.buildingSeconds,
          .tracing = rendering.seconds * tracingPart,
          .shading = rendering.seconds * (1.0 - tracingPart),
          .writing = writingSeconds};
}

std::string timesText(const RunTimes& times) {
  const std::array<std::pair<std::string_view, double>, 5> steps = {{{"reading", times.reading},
                                                                     {"building", times.building},
                                                                     {"tracing", times.tracing},
                                                                     {"shading", times.shading},
                                                                     {"writing", times.writing}}};
  double sum = 0.0;
  for (const auto& [name, seconds] : steps)
    sum += seconds;
  std::string text = "time:";
  for (const auto& [name, seconds] : steps) {
    text += fmt::format("{} {} {:.2f} s ({:.0f} %)", text.ends_with(':') ? "" : ",", name, seconds,
                        sum > 0.0 ? 100.0 * seconds / sum : 0.0);
  }
  return text;
}

Json summaryJson(const FinishedPicture& picture, const PictureFile& file, const RunTimes& times) {
  const RenderCommand& command = picture.command;
  const Subject& subject = picture.subject;
  const PicturePlan& plan = picture.plan;
  const render::RenderSettings settings = renderSettings(command, subject, plan);
  return {
      {"model", command.model ? Json(command.model->string()) : Json(nullptr)},
      {"picture", outputPath(command).string()},
      {"format", formatName(chosenFormat(command))},
      {"width", file.size.width},
      {"height", file.size.height},
      {"byte_count", file.bytes.size()},
      {"command", reproducingCommand(picture)},
      {"mode", modeName(plan.mode)},
      {"samples", samplesJson(settings)},
      {"seed", command.seed},
      {"whitted", whittedJson(settings)},
      {"crop", cropJson(command.crop)},
      {"cell_depth", command.cellDepth ? Json(*command.cellDepth) : Json(nullptr)},
      {"camera", cameraJson(plan)},
      {"mesh", subject.mesh},
      {"scene", subject.materials},
      {"build", buildJson(subject.options, subject.report)},
      {"tree", treeJson(subject.statistics)},
      {"range", rangeJson(picture.rendering.range)},
      {"is_complete", picture.rendering.isComplete},
      {"done", picture.rendering.done},
      {"ray_count", picture.rendering.rayCount},
      {"render_seconds", picture.rendering.seconds},
      {"times", timesJson(times)},
  };
}

}  // namespace planetree::tool
