#include "bench/render/measure_pictures.hpp"

#include "bench/render/ray_mesh.hpp"
#include "bench/support/build_info.hpp"
#include "bench/support/interleaved.hpp"
#include "bench/support/measure.hpp"
#include "bench/support/summary.hpp"
#include "tools/planetree/command_options.hpp"
#include "tools/planetree/option_values.hpp"
#include "tools/planetree/picture_file.hpp"
#include "tools/planetree/picture_plan.hpp"
#include "tools/planetree/render_summary.hpp"
#include "tools/planetree/talk.hpp"

#include "scene/build_scene.hpp"
#include "scene/read_scene.hpp"

#include <planetree/build_tree.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <variant>

namespace planetree::bench {

namespace {

/// One picture from the file of its scene to the bytes of its own.
struct PictureRun {
  tool::RunTimes times;
  std::uint64_t rayCount = 0;
  std::uint64_t objectCount = 0;
  std::string mode;
  std::vector<std::byte> bytes;
};

tool::RenderCommand commandFor(const std::filesystem::path& file, unsigned threadCount,
                               std::uint32_t width) {
  tool::RenderCommand command;
  command.model = file;
  command.size.width = width;
  command.size.height.reset();
  command.run.threadCount = threadCount;
  command.run.isQuiet = true;
  return command;
}

PictureRun takePicture(const tool::RenderCommand& command) {
  const tool::SubjectSourcePtr source = readSource(command, tool::Talk(command.run.isQuiet));
  const tool::Subject subject = source->build(
      {.options = buildOptions(command.tree, command.run), .control = buildControl(command.run)});
  const tool::PicturePlan plan = planPicture(command, subject);
  const render::Rendering rendering =
      renderImage(*subject.tracer, renderSettings(command, subject, plan));
  const tool::FinishedPicture picture = {command, subject, plan, rendering};
  PictureRun run;
  const double encoding = secondsOf([&] { run.bytes = encodePicture(picture).bytes; });
  run.times = runTimes(picture, encoding);
  run.rayCount = rendering.rayCount;
  run.objectCount = subject.report.objectCount;
  run.mode = tool::modeName(plan.mode);
  return run;
}

/// The best times so far, and the round that rendered fastest.
struct BestRun {
  tool::RunTimes times{.reading = std::numeric_limits<double>::infinity(),
                       .building = std::numeric_limits<double>::infinity(),
                       .tracing = std::numeric_limits<double>::infinity(),
                       .shading = 0.0,
                       .writing = std::numeric_limits<double>::infinity()};

  void add(const tool::RunTimes& round) {
    times.reading = std::min(times.reading, round.reading);
    times.building = std::min(times.building, round.building);
    times.writing = std::min(times.writing, round.writing);
    if (round.tracing + round.shading < times.tracing + times.shading) {
      times.tracing = round.tracing;
      times.shading = round.shading;
    }
  }
};

/// A result that has everything but its measure and value.
Result emptyResult(std::string scene, unsigned threadCount) {
  Result result;
  result.scene = std::move(scene);
  result.engine = "planetree";
  result.mode = "balanced-watertight";
  result.threadCount = threadCount;
  result.isDefault = true;
  result.commit = commit();
  result.compiler = compiler();
  return result;
}

void addResult(std::vector<Result>& results, Result result, std::string_view measure,
               double value) {
  result.measure = measure;
  result.value = value;
  results.push_back(std::move(result));
}

constexpr std::size_t kMeshFaces = 10'000;

scene::SceneDescription readText(const std::string& text) {
  return scene::readRayScene(std::as_bytes(std::span(text)), "trimesh.ray", "");
}

void checkRayMesh(const scene::SceneDescription& scene, const TriangleMesh<float>& written) {
  const auto* const read =
      std::get_if<std::shared_ptr<const scene::MeshShape>>(&scene.shapes.at(0).shape);
  const bool isSame =
      read != nullptr &&
      std::ranges::equal((*read)->faces, written.faces,
                         [](const auto& a, const auto& b) { return std::ranges::equal(a, b); }) &&
      std::ranges::equal((*read)->positions, written.positions,
                         [](const Vec3d& a, const Vec3f& b) { return Vec3f(a) == b; });
  if (!isSame)
    throw WrongAnswers("trimesh-10k: what was read is not the mesh that was written");
}

}  // namespace

std::vector<Result> measurePicture(const std::filesystem::path& file,
                                   const PictureSettings& settings) {
  std::vector<tool::RenderCommand> commands;
  for (const unsigned threadCount : settings.threadCounts)
    commands.push_back(commandFor(file, threadCount, settings.width));
  const PictureRun first = takePicture(commands.front());
  settings.say(fmt::format("{}, {}", file.filename().string(), first.mode));
  for (std::size_t i = 1; i < commands.size(); ++i) {
    if (takePicture(commands[i]).bytes != first.bytes) {
      throw WrongAnswers(fmt::format("{}: the picture of {} differs from that of {}", file.string(),
                                     threadText(settings.threadCounts[i]),
                                     threadText(settings.threadCounts[0])));
    }
  }

  std::vector<BestRun> best(commands.size());
  static_cast<void>(bestOfRounds(commands.size(), settings.rounds, [&](std::size_t i) {
    const tool::RunTimes times = takePicture(commands[i]).times;
    best[i].add(times);
    return times.tracing + times.shading;
  }));
  std::vector<Result> results;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    Result result = emptyResult(file.filename().string(), settings.threadCounts[i]);
    result.kind = first.mode;
    result.objectCount = first.objectCount;
    const tool::RunTimes& times = best[i].times;
    addResult(results, result, kPictureReadingSeconds, times.reading);
    addResult(results, result, kPictureBuildingSeconds, times.building);
    addResult(results, result, kPictureTracingSeconds, times.tracing);
    addResult(results, result, kPictureShadingSeconds, times.shading);
    addResult(results, result, kPictureEncodingSeconds, times.writing);
    addResult(results, result, kPictureRays, static_cast<double>(first.rayCount));
  }
  return results;
}

std::vector<Result> measureRayMesh(const PictureSettings& settings) {
  const TriangleMesh<float> mesh = makeRayMesh(kMeshFaces);
  const std::string text = rayText(mesh);
  settings.say(fmt::format("trimesh-10k: {} faces in {} bytes", mesh.faces.size(), text.size()));
  checkRayMesh(readText(text), mesh);

  std::vector<BestRun> best(settings.threadCounts.size());
  static_cast<void>(bestOfRounds(best.size(), settings.rounds, [&](std::size_t i) {
    scene::SceneDescription scene;
    BuildOptions options;
    options.threadCount = settings.threadCounts[i];
    tool::RunTimes times = best[i].times;
    times.reading = secondsOf([&] { scene = readText(text); });
    times.building = secondsOf([&] { const scene::BuiltScene built(std::move(scene), options); });
    best[i].add(times);
    return times.building;
  }));
  std::vector<Result> results;
  for (std::size_t i = 0; i < best.size(); ++i) {
    Result result = emptyResult("trimesh-10k", settings.threadCounts[i]);
    result.objectCount = mesh.faces.size();
    addResult(results, result, kPictureReadingSeconds, best[i].times.reading);
    addResult(results, result, kPictureBuildingSeconds, best[i].times.building);
  }
  return results;
}

}  // namespace planetree::bench
