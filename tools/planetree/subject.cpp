#include "subject.hpp"

#include "model.hpp"
#include "progress_line.hpp"
#include "scene_file.hpp"

#include "render/still_life.hpp"
#include "scene/scene_bounds.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/error.hpp>

#include <fmt/format.h>

#include <chrono>
#include <utility>
#include <variant>

namespace planetree::tool {

namespace {

using Clock = std::chrono::steady_clock;
using scene::SceneDescription;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

template <Object O>
void takeTree(Subject& subject, KdTree<O> tree) {
  subject.options = tree.options();
  subject.report = tree.report();
  subject.statistics = tree.statistics();
  subject.tracer = std::make_unique<render::TreeTracer<O>>(std::move(tree));
}

Vec3f corner(const Box3& box, unsigned number) noexcept {
  return {(number & 1u) != 0 ? box.upper.x : box.lower.x,
          (number & 2u) != 0 ? box.upper.y : box.lower.y,
          (number & 4u) != 0 ? box.upper.z : box.lower.z};
}

/// The vertices of meshes, and for other shapes the corners of the box around them.
std::vector<Vec3f> outline(const SceneDescription& description) {
  std::vector<Vec3f> points;
  for (const scene::PlacedShape& shape : description.shapes) {
    if (const auto* mesh = std::get_if<std::shared_ptr<const scene::MeshShape>>(&shape.shape)) {
      for (const Vec3d& position : (*mesh)->positions)
        points.emplace_back(shape.placement.point(position));
      continue;
    }
    SceneDescription alone;
    alone.shapes.push_back(shape);
    const Box3 box = boundsOf(alone);
    for (unsigned i = 0; i < 8 && !box.isEmpty(); ++i)
      points.push_back(corner(box, i));
  }
  return points;
}

Json materialsJson(const SceneDescription& description) {
  return {{"shape_count", description.shapes.size()},
          {"material_count", description.materials.size()},
          {"texture_count", description.textures.size()},
          {"point_light_count", description.pointLights.size()},
          {"directional_light_count", description.directionalLights.size()},
          {"has_camera", description.view.has_value()}};
}

void sayScene(const Talk& talk, const SceneDescription& description, double seconds) {
  talk.say(fmt::format(
      "{}: {}, {}, {}, {} (read in {:.2f} s)", description.name,
      counted(description.shapes.size(), "shape"),
      counted(description.materials.size(), "material"),
      counted(description.textures.size(), "texture"),
      counted(description.pointLights.size() + description.directionalLights.size(), "light"),
      seconds));
  for (const std::string& remark : description.remarks)
    talk.say("  " + remark);
}

SceneDescription readWithProgress(const std::filesystem::path& path,
                                  const std::optional<CubeMapPaths>& background, const Talk& talk) {
  const ProgressLine progress("reading " + path.filename().string(), talk.showsProgress());
  SceneDescription description = readScene(path);
  if (background) {
    scene::CubeMap cube{};
    for (std::size_t i = 0; i < cube.textures.size(); ++i) {
      cube.textures[i] = static_cast<std::uint32_t>(description.textures.size());
      description.textures.push_back(scene::readTexture((*background)[i]));
    }
    description.background = cube;
  }
  return description;
}

scene::BuiltScene buildWithProgress(SceneDescription description, const BuildSetup& setup,
                                    const Talk& talk) {
  ProgressLine line("building the tree", talk.showsProgress());
  BuildControl control = setup.control;
  control.onProgress = [&line](const BuildProgress& progress) { line.update(progress.done); };
  return scene::BuiltScene(std::move(description), setup.options, control);
}

}  // namespace

Subject readModelSubject(const std::filesystem::path& path, const BuildSetup& setup,
                         const render::Framing& framing, const Talk& talk) {
  const Clock::time_point start = Clock::now();
  Model<float> model = readModel<float>(path, talk);
  Subject subject;
  subject.name = path.filename().string();
  subject.readingSeconds = secondsSince(start);
  // Before the tree: a mesh that cannot be shown has no camera either, and building says why.
  subject.camera =
      frameCamera(render::visiblePoints(model.mesh.view()), framing).value_or(render::Camera{});
  subject.mesh =
      meshJson({.faceCount = model.mesh.faces.size(), .vertexCount = model.mesh.positions.size()},
               model.report);
  takeTree(subject, buildModelTree(std::move(model), setup.options, setup.control, talk));
  subject.buildingSeconds = subject.report.totalSeconds;
  return subject;
}

Subject readSceneSubject(const std::filesystem::path& path, const BuildSetup& setup,
                         const render::Framing& framing,
                         const std::optional<CubeMapPaths>& background, const Talk& talk,
                         const std::function<void(const SceneDescription&)>& check) {
  const Clock::time_point start = Clock::now();
  SceneDescription description = readWithProgress(path, background, talk);
  if (description.shapes.empty() && !isSceneFile(path)) {
    throw Error(ErrorCode::InvalidGeometry, "has no triangles",
                "Rays do not hit point clouds and curves: export the model with its faces.",
                {.file = path.string()});
  }
  Subject subject;
  subject.name = path.filename().string();
  subject.readingSeconds = secondsSince(start);
  sayScene(talk, description, subject.readingSeconds);
  check(description);
  subject.view = description.view;
  subject.camera = frameCamera(outline(description), framing).value_or(render::Camera{});
  subject.materials = materialsJson(description);

  const Clock::time_point buildStart = Clock::now();
  subject.scene = std::make_unique<const scene::BuiltScene>(
      buildWithProgress(std::move(description), setup, talk));
  subject.buildingSeconds = secondsSince(buildStart);
  takeTree(subject, subject.scene->tree());
  if (subject.report.skippedCount != 0) {
    talk.say(fmt::format("  skipped {} of {}: {}", grouped(subject.report.skippedCount),
                         counted(subject.report.objectCount, "object"),
                         reasonText(subject.report.skipped.front().reason)));
  }
  sayTree(talk, subject.report, subject.statistics, "object");
  return subject;
}

Subject makeStillLifeSubject(const BuildSetup& setup, const render::Framing& framing,
                             const Talk& talk) {
  render::StillLife stillLife = render::makeStillLife();
  talk.say("no model given: a still life of spheres, boxes, cones, cylinders, squares and a knot");
  Subject subject;
  subject.name = "still life";
  subject.camera = frameCamera(stillLife.outline, framing).value_or(render::Camera{});
  subject.albedos = std::move(stillLife.albedos);
  takeTree(subject, buildTree(stillLife.scene, setup.options, setup.control));
  subject.buildingSeconds = subject.report.totalSeconds;
  sayTree(talk, subject.report, subject.statistics, "object");
  return subject;
}

}  // namespace planetree::tool
