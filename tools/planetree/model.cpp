#include "model.hpp"

#include "progress_line.hpp"
#include "ray_files/byte_source.hpp"

#include <planetree/error.hpp>

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

namespace planetree::tool {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Where the bytes of a model come from.
std::filesystem::path sourceOf(const std::filesystem::path& path) {
  return path == kStandardInput ? std::filesystem::path("/dev/stdin") : path;
}

template <std::floating_point T>
KdTree<Face<T>> buildWithProgress(TriangleMesh<T> mesh, const BuildOptions& options,
                                  BuildControl control, const Talk& talk) {
  ProgressLine line("building the tree", talk.showsProgress());
  control.onProgress = [&line](const BuildProgress& progress) { line.update(progress.done); };
  return buildTree(std::move(mesh), options, control);
}

std::string displayName(const std::filesystem::path& path) {
  return path == kStandardInput ? "standard input" : path.string();
}

}  // namespace

template <std::floating_point T>
Model<T> readModel(const std::filesystem::path& path, const Talk& talk) {
  const Clock::time_point start = Clock::now();
  Model<T> model{.name = displayName(path), .mesh = {}, .report = {}};
  const std::string fileName = path == kStandardInput ? model.name : path.filename().string();
  {
    const ProgressLine progress("reading " + fileName, talk.showsProgress());
    model.mesh = importing::importMesh<T>(sourceOf(path), &model.report);
  }
  const MeshSize size{.faceCount = model.mesh.faces.size(),
                      .vertexCount = model.mesh.positions.size()};
  sayMesh(talk, fileName, size, model.report, secondsSince(start));
  if (model.mesh.faces.empty()) {
    throw Error(ErrorCode::InvalidGeometry, "has no triangles",
                "Rays do not hit point clouds and curves: export the model with its faces.",
                {.file = model.name});
  }
  return model;
}

void requireHittable(const BuildReport& report, const std::string& name) {
  if (report.skippedCount == report.objectCount) {
    throw Error(
        ErrorCode::InvalidGeometry,
        fmt::format("has {}, none of which can be hit", counted(report.objectCount, "triangle")),
        fmt::format("The first one {}: check how the model was exported.",
                    reasonText(report.skipped.front().reason)),
        {.file = name});
  }
}

template <std::floating_point T>
KdTree<Face<T>> buildModelTree(Model<T> model, const BuildOptions& options,
                               const BuildControl& control, const Talk& talk) {
  const std::vector<std::uint32_t> sourceFaces = model.mesh.sourceFaces;
  auto tree = buildWithProgress(std::move(model.mesh), options, control, talk);
  const BuildReport& report = tree.report();
  sayRange(talk, report);
  saySkipped(talk, report, sourceFaces);
  requireHittable(report, model.name);
  sayTree(talk, report, tree.statistics(), "triangle");
  return tree;
}

template Model<float> readModel<float>(const std::filesystem::path&, const Talk&);
template Model<double> readModel<double>(const std::filesystem::path&, const Talk&);
template KdTree<Face<float>> buildModelTree<float>(Model<float>, const BuildOptions&,
                                                   const BuildControl&, const Talk&);
template KdTree<Face<double>> buildModelTree<double>(Model<double>, const BuildOptions&,
                                                     const BuildControl&, const Talk&);

}  // namespace planetree::tool
