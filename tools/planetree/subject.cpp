#include "subject.hpp"

#include "render/still_life.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/error.hpp>
#include <planetree/mesh/read_mesh.hpp>

#include <fmt/format.h>

#include <chrono>
#include <string>
#include <utility>

namespace planetree::tool {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Builds the tree, which takes the mesh, and says how that went.
std::unique_ptr<render::Tracer> buildTracer(TriangleMesh<float> mesh, const BuildOptions& options,
                                            const std::string& name, const Talk& talk) {
  const std::vector<std::uint32_t> sourceFaces = mesh.sourceFaces;
  auto tree = buildTree(std::move(mesh), options);
  const BuildReport& report = tree.report();
  saySkipped(talk, report, sourceFaces);
  if (report.skippedCount == report.objectCount) {
    throw Error(ErrorCode::InvalidGeometry,
                fmt::format("none of its {} triangles can be shown", grouped(report.objectCount)),
                fmt::format("The first one {}: check how the model was exported.",
                            reasonText(report.skipped.front().reason)),
                {.file = name});
  }
  sayTree(talk, report, tree.statistics(), "triangles");
  return std::make_unique<render::TreeTracer<Face<float>>>(std::move(tree));
}

}  // namespace

Subject readModel(const std::filesystem::path& path, const BuildOptions& options,
                  const render::Framing& framing, const Talk& talk) {
  const std::string name = path.string();
  const Clock::time_point start = Clock::now();
  MeshReadReport readReport;
  auto mesh = readMesh<float>(path, &readReport);
  sayMesh(talk, path.filename().string(), mesh, readReport, secondsSince(start));
  if (mesh.faces.empty()) {
    throw Error(ErrorCode::InvalidGeometry, "has no triangles",
                "Point clouds and curves cannot be rendered: export the model with its faces.",
                {.file = name});
  }
  // Before the tree: a mesh that cannot be shown has no camera either, and building says why.
  const auto camera = frameCamera(render::visiblePoints(mesh.view()), framing);
  auto tracer = buildTracer(std::move(mesh), options, name, talk);
  return {.tracer = std::move(tracer), .camera = camera.value_or(render::Camera{}), .albedos = {}};
}

Subject makeStillLifeSubject(const BuildOptions& options, const render::Framing& framing,
                             const Talk& talk) {
  const render::StillLife stillLife = render::makeStillLife();
  const auto camera = frameCamera(stillLife.outline, framing);
  auto tree = buildTree(stillLife.scene, options);
  talk.say("no model given: a still life of spheres, boxes, cones, cylinders, squares and a knot");
  sayTree(talk, tree.report(), tree.statistics(), "objects");
  return {.tracer = std::make_unique<render::TreeTracer<AnyObject<float>>>(std::move(tree)),
          .camera = camera.value_or(render::Camera{}),
          .albedos = stillLife.albedos};
}

}  // namespace planetree::tool
