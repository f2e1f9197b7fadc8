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

#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace planetree::tool {

/// What a picture is taken of.
struct Subject {
  std::string name;  ///< the file's, without its folder
  std::unique_ptr<render::Tracer> tracer;
  std::unique_ptr<const scene::BuiltScene> scene;  ///< if it has materials
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

/// How trees are to be built.
struct BuildSetup {
  BuildOptions options;
  BuildControl control;
};

/// A model from a file, in a tree. Throws `Error` if it cannot be read or has nothing to show.
[[nodiscard]] Subject readModelSubject(const std::filesystem::path& path, const BuildSetup& setup,
                                       const render::Framing& framing, const Talk& talk);

/// Six images around a scene.
using CubeMapPaths = std::array<std::filesystem::path, 6>;

/// A scene, or a model with its materials and lights. `check` is told about it before its tree is
/// built, and may throw. Throws `Error` if it cannot be read.
[[nodiscard]] Subject readSceneSubject(
    const std::filesystem::path& path, const BuildSetup& setup, const render::Framing& framing,
    const std::optional<CubeMapPaths>& background, const Talk& talk,
    const std::function<void(const scene::SceneDescription&)>& check);

/// The scene made in code, in a tree.
[[nodiscard]] Subject makeStillLifeSubject(const BuildSetup& setup, const render::Framing& framing,
                                           const Talk& talk);

}  // namespace planetree::tool
