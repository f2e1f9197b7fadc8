#pragma once

#include <planetree/mesh/read_mesh.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include "support/expected_error.hpp"
#include "support/promise.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

/// What holds of every mesh that was read, whatever the bytes were.
namespace planetree::fuzz {

template <class T>
void requireSoundMesh(const TriangleMesh<T>& mesh, std::size_t byteCount) {
  require(mesh.positions.size() <= byteCount, "a vertex takes at least a byte");
  require(mesh.faces.size() <= byteCount, "a triangle takes at least a byte");
  for (const FaceIndices& face : mesh.faces) {
    for (const std::uint32_t corner : face)
      require(corner < mesh.positions.size(), "faces refer to vertices that there are");
  }
  require(mesh.sourceFaces.empty() || mesh.sourceFaces.size() == mesh.faces.size(),
          "all faces have a source or none");
}

template <class T>
void requireSoundReport(const TriangleMesh<T>& mesh, const MeshReadReport& report) {
  require(report.skippedPolygonCount <= report.polygonCount, "skipped polygons are counted, too");
  require(report.skipped.size() <= report.skippedPolygonCount, "no more are named than skipped");
  for (const SkippedPolygon& skipped : report.skipped) {
    require(skipped.polygon < report.polygonCount, "a skipped polygon is one of the file's");
    require(!skipped.reason.empty(), "a skipped polygon has a reason");
  }
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face)
    require(mesh.sourceFace(face) < report.polygonCount, "sources are polygons of the file");
}

template <class T>
struct ReadResult {
  TriangleMesh<T> mesh;
  MeshReadReport report;
};

/// Reads in both precisions.
inline void checkMeshReader(const std::uint8_t* data, std::size_t size, const std::string& name) {
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto read = [&]<class T>(ReadResult<T> result) {
    result.mesh = readMesh<T>(bytes, name, &result.report);
    requireSoundMesh(result.mesh, size);
    requireSoundReport(result.mesh, result.report);
    return result;
  };
  const auto inFloat = readOrRefuse(name, [&] { return read(ReadResult<float>{}); });
  const auto inDouble = readOrRefuse(name, [&] { return read(ReadResult<double>{}); });
  require(inFloat.has_value() == inDouble.has_value(),
          "what can be read does not depend on the precision");
  if (!inFloat)
    return;
  require(inFloat->report.format == inDouble->report.format, "nor does the format");
  require(inFloat->report.polygonCount == inDouble->report.polygonCount, "nor do the polygons");
  require(inFloat->mesh.sourceFaces == inDouble->mesh.sourceFaces, "nor do their sources");
  // Equal corners of STL become one vertex, and more are equal in float.
  if (inFloat->report.format != MeshFormat::Stl)
    require(inFloat->mesh.faces == inDouble->mesh.faces, "nor do the faces");
}

}  // namespace planetree::fuzz
