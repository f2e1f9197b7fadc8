#pragma once

#include "json_text.hpp"
#include "talk.hpp"

#include "render/camera.hpp"
#include "render/framing.hpp"
#include "render/tracer.hpp"
#include "scene/build_scene.hpp"
#include "scene/view.hpp"

#include <planetree/geometry/vec3.hpp>
#include <planetree/node/tree_statistics.hpp>
#include <planetree/split/build_control.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/split/build_report.hpp>
#include <planetree/traversal/query_options.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planetree::tool {

/// What a picture is taken of, in a tree. Copies share the tree.
struct Subject {
  std::string name;  ///< the file's, without its folder
  std::shared_ptr<const render::Tracer> tracer;
  std::shared_ptr<const scene::BuiltScene> scene;  ///< if it has materials
  std::optional<scene::View> view;                 ///< the camera that it brings
  render::Camera camera;                           ///< the view that shows all of it
  std::vector<Vec3f> albedos;
  Json mesh;       ///< as in json_text.hpp; null if it does not come from a file of a model
  Json materials;  ///< what the scene has; null if it is none
  BuildOptions options;
  BuildReport report;
  TreeStatistics statistics;
  double readingSeconds = 0.0;
  double buildingSeconds = 0.0;

  [[nodiscard]] bool isScene() const noexcept { return scene != nullptr; }
};

/// How a tree is to be built, and what all rays of a picture have in common.
struct BuildSetup {
  BuildOptions options;
  BuildControl control;
  QueryOptions query = {};
};

/// What has been read and can be put into trees, each built by other rules. It must outlive the
/// subjects that it makes.
class SubjectSource {
 public:
  virtual ~SubjectSource() = default;

  /// In a tree of its own; says nothing. Throws `Error` if a model has nothing that can be hit, and
  /// as `buildTree` does.
  [[nodiscard]] Subject build(const BuildSetup& setup) const;

  /// Says how that went.
  void sayBuilt(const Talk& talk, const Subject& subject) const;

  /// What its tree holds, in the singular.
  [[nodiscard]] virtual std::string_view objectName() const noexcept { return "object"; }

 protected:
  /// As it is before there is a tree.
  Subject unbuilt_;

 private:
  virtual void buildTreeOf(Subject& subject, const BuildSetup& setup) const = 0;
  virtual void saySkippedOf(const Talk& talk, const BuildReport& report) const = 0;
};

using SubjectSourcePtr = std::unique_ptr<const SubjectSource>;

/// A model from a file. Throws `Error` if it cannot be read or has no triangles.
[[nodiscard]] SubjectSourcePtr readModelSource(const std::filesystem::path& path,
                                               const render::Framing& framing, const Talk& talk);

/// Six images around a scene.
using CubeMapPaths = std::array<std::filesystem::path, 6>;

/// A scene, or a model with its materials and lights. `check` is told about it, and may throw.
/// Throws `Error` if it cannot be read.
[[nodiscard]] SubjectSourcePtr readSceneSource(
    const std::filesystem::path& path, const render::Framing& framing,
    const std::optional<CubeMapPaths>& background, const Talk& talk,
    const std::function<void(const scene::SceneDescription&)>& check);

/// The scene made in code.
[[nodiscard]] SubjectSourcePtr makeStillLifeSource(const render::Framing& framing,
                                                   const Talk& talk);

}  // namespace planetree::tool
