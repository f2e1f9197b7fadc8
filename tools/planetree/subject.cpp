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
void takeTree(Subject& subject, KdTree<O> tree, const QueryOptions& query) {
  subject.options = tree.options();
  subject.report = tree.report();
  subject.statistics = tree.statistics();
  subject.tracer = std::make_shared<const render::TreeTracer<O>>(std::move(tree), query);
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
          {"has_camera", description.view.has_value()},
          {"remarks", description.remarks}};
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

class ModelSource final : public SubjectSource {
 public:
  ModelSource(const std::filesystem::path& path, const render::Framing& framing, const Talk& talk) {
    const Clock::time_point start = Clock::now();
    model_ = readModel<float>(path, talk);
    unbuilt_.name = path.filename().string();
    unbuilt_.readingSeconds = secondsSince(start);
    // A mesh that cannot be shown has no camera either, and building says why.
    unbuilt_.camera =
        frameCamera(render::visiblePoints(model_.mesh.view()), framing).value_or(render::Camera{});
    unbuilt_.mesh = meshJson(
        {.faceCount = model_.mesh.faces.size(), .vertexCount = model_.mesh.positions.size()},
        model_.report);
  }
  [[nodiscard]] std::string_view objectName() const noexcept override { return "triangle"; }

 private:
  void buildTreeOf(Subject& subject, const BuildSetup& setup) const override {
    takeTree(subject, buildTree(model_.mesh.view(), setup.options, setup.control), setup.query);
    requireHittable(subject.report, model_.name);
    subject.buildingSeconds = subject.report.totalSeconds;
  }
  void saySkippedOf(const Talk& talk, const BuildReport& report) const override {
    saySkipped(talk, report, model_.mesh.sourceFaces);
  }

  Model<float> model_;
};

class SceneSource final : public SubjectSource {
 public:
  SceneSource(const std::filesystem::path& path, const render::Framing& framing,
              const std::optional<CubeMapPaths>& background, const Talk& talk) {
    const Clock::time_point start = Clock::now();
    description_ =
        std::make_shared<const SceneDescription>(readWithProgress(path, background, talk));
    if (description_->shapes.empty() && !isSceneFile(path)) {
      throw Error(ErrorCode::InvalidGeometry, "has no triangles",
                  "Rays do not hit point clouds and curves: export the model with its faces.",
                  {.file = path.string()});
    }
    unbuilt_.name = path.filename().string();
    unbuilt_.readingSeconds = secondsSince(start);
    sayScene(talk, *description_, unbuilt_.readingSeconds);
    unbuilt_.view = description_->view;
    unbuilt_.camera = frameCamera(outline(*description_), framing).value_or(render::Camera{});
    unbuilt_.materials = materialsJson(*description_);
  }
  [[nodiscard]] const SceneDescription& description() const noexcept { return *description_; }

 private:
  void buildTreeOf(Subject& subject, const BuildSetup& setup) const override {
    const Clock::time_point start = Clock::now();
    subject.scene =
        std::make_shared<const scene::BuiltScene>(description_, setup.options, setup.control);
    subject.buildingSeconds = secondsSince(start);
    takeTree(subject, subject.scene->tree(), setup.query);
  }
  void saySkippedOf(const Talk& talk, const BuildReport& report) const override {
    if (report.skippedCount == 0)
      return;
    talk.say(fmt::format("  skipped {} of {}: {}", grouped(report.skippedCount),
                         counted(report.objectCount, "object"),
                         reasonText(report.skipped.front().reason)));
  }

  std::shared_ptr<const SceneDescription> description_;
};

class StillLifeSource final : public SubjectSource {
 public:
  explicit StillLifeSource(const render::Framing& framing) {
    unbuilt_.name = "still life";
    unbuilt_.camera = frameCamera(stillLife_.outline, framing).value_or(render::Camera{});
    unbuilt_.albedos = stillLife_.albedos;
  }

 private:
  void buildTreeOf(Subject& subject, const BuildSetup& setup) const override {
    takeTree(subject, buildTree(stillLife_.scene, setup.options, setup.control), setup.query);
    subject.buildingSeconds = subject.report.totalSeconds;
  }
  void saySkippedOf(const Talk&, const BuildReport&) const override {}

  render::StillLife stillLife_ = render::makeStillLife();
};

}  // namespace

Subject SubjectSource::build(const BuildSetup& setup) const {
  Subject subject = unbuilt_;
  buildTreeOf(subject, setup);
  return subject;
}

void SubjectSource::sayBuilt(const Talk& talk, const Subject& subject) const {
  sayRange(talk, subject.report);
  saySkippedOf(talk, subject.report);
  sayTree(talk, subject.report, subject.statistics, objectName());
}

SubjectSourcePtr readModelSource(const std::filesystem::path& path, const render::Framing& framing,
                                 const Talk& talk) {
  return std::make_unique<const ModelSource>(path, framing, talk);
}

SubjectSourcePtr readSceneSource(const std::filesystem::path& path, const render::Framing& framing,
                                 const std::optional<CubeMapPaths>& background, const Talk& talk,
                                 const std::function<void(const SceneDescription&)>& check) {
  auto source = std::make_unique<const SceneSource>(path, framing, background, talk);
  check(source->description());
  return source;
}

SubjectSourcePtr makeStillLifeSource(const render::Framing& framing, const Talk& talk) {
  talk.say("no model given: a still life of spheres, boxes, cones, cylinders, squares and a knot");
  return std::make_unique<const StillLifeSource>(framing);
}

}  // namespace planetree::tool
