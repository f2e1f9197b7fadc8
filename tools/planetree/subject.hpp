#pragma once

#include "json_text.hpp"
#include "talk.hpp"

#include "render/camera.hpp"
#include "render/framing.hpp"
#include "render/tracer.hpp"

#include <planetree/geometry/vec3.hpp>
#include <planetree/node/tree_statistics.hpp>
#include <planetree/split/build_control.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/split/build_report.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace planetree::tool {

/// What a picture is taken of.
struct Subject {
  std::string name;  ///< the file's, without its folder
  std::unique_ptr<render::Tracer> tracer;
  render::Camera camera;  ///< the view that shows all of it
  std::vector<Vec3f> albedos;
  Json mesh;  ///< as in json_text.hpp; null if it does not come from a file
  BuildOptions options;
  BuildReport report;
  TreeStatistics statistics;
};

/// A model from a file, in a tree. Throws `Error` if it cannot be read or has nothing to show.
[[nodiscard]] Subject readModelSubject(const std::filesystem::path& path,
                                       const BuildOptions& options, const BuildControl& control,
                                       const render::Framing& framing, const Talk& talk);

/// The scene made in code, in a tree.
[[nodiscard]] Subject makeStillLifeSubject(const BuildOptions& options, const BuildControl& control,
                                           const render::Framing& framing, const Talk& talk);

}  // namespace planetree::tool
