#pragma once

#include <planetree/mesh/triangle_mesh.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace planetree {

/// The model files that can be read. Told apart by their content, not by their name. `Other` is for
/// programs that fill in a report themselves, for a format of their own.
enum class MeshFormat : std::uint8_t { Ply, Stl, Obj, Off, Other };

/// A polygon of the file that could not become triangles, and why.
struct SkippedPolygon {
  std::uint64_t polygon = 0;  ///< index among the polygons of the file
  std::int64_t line = -1;     ///< where it stands in a text format, counted from 1; else -1
  std::string reason;         ///< "refers to vertex 9, which does not exist", ...
};

/// What reading found beside the mesh. Nothing is dropped in silence.
struct MeshReadReport {
  MeshFormat format = MeshFormat::Ply;
  std::uint64_t polygonCount = 0;         ///< polygons in the file, the skipped ones included
  std::uint64_t skippedPolygonCount = 0;  ///< all of them
  std::vector<SkippedPolygon> skipped;    ///< the first few
  /// Points, lines, curves and surfaces of OBJ files: they have no polygons and are not read.
  std::uint64_t unreadPrimitiveCount = 0;
  /// Finite coordinates of the file that are too large for T and so became infinity.
  std::uint64_t tooLargeCount = 0;
};

/// Reads a model into one mesh: PLY (ASCII, binary little and big endian), STL (ASCII and binary),
/// OBJ (all its objects and groups together) or OFF (ASCII, three coordinates). Only positions and
/// polygons are read: no colours, normals or materials.
///
/// Polygons with more than three corners are cut into a fan of triangles that remember their source
/// (`TriangleMesh::sourceFace` is the polygon's index in the file). A polygon with fewer than three
/// corners or with a vertex index out of range is skipped and counted; the others keep their source
/// index. Each triangle of a PLY strip is a polygon of its own. Equal corners of STL facets, those
/// with the same coordinates in T, become one vertex.
///
/// Coordinates are rounded once to the nearest T; those too large for T become infinity and are
/// counted. Vertices that are not finite are kept: the tree skips and counts the faces that use
/// them.
///
/// Throws `Error` with `FileNotReadable` (missing, a folder, no permission, written to meanwhile),
/// `UnknownFormat` (also for an empty file), `MalformedFile` (truncated, counts that do not fit the
/// file, not a number, unknown keywords), or `CapacityExceeded` (more vertices or triangles than 32
/// bits can count), naming the file and, in text formats, the line; the report is then left as it
/// was. A file without polygons gives an empty mesh. Any thread may call it. Time and memory grow
/// linearly with the size of the file, whatever its header claims.
template <std::floating_point T>
[[nodiscard]] TriangleMesh<T> readMesh(const std::filesystem::path& path,
                                       MeshReadReport* report = nullptr);

/// The same from bytes in memory; `name` stands in for the file name in errors.
template <std::floating_point T>
[[nodiscard]] TriangleMesh<T> readMesh(std::span<const std::byte> bytes, const std::string& name,
                                       MeshReadReport* report = nullptr);

extern template TriangleMesh<float> readMesh<float>(const std::filesystem::path&, MeshReadReport*);
extern template TriangleMesh<double> readMesh<double>(const std::filesystem::path&,
                                                      MeshReadReport*);
extern template TriangleMesh<float> readMesh<float>(std::span<const std::byte>, const std::string&,
                                                    MeshReadReport*);
extern template TriangleMesh<double> readMesh<double>(std::span<const std::byte>,
                                                      const std::string&, MeshReadReport*);

}  // namespace planetree
