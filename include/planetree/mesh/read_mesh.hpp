#pragma once

#include <planetree/mesh/triangle_mesh.hpp>

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace planetree {

/// The model files that can be read. Told apart by their content, not by their name.
enum class MeshFormat : std::uint8_t { Ply, Stl, Obj };

/// A polygon of the file that could not become triangles, and why.
struct SkippedPolygon {
  std::uint64_t polygon = 0;  ///< index among the polygons of the file
  std::string reason;         ///< "has fewer than three corners", ...
};

/// What reading found beside the mesh. Nothing is dropped in silence.
struct MeshReadReport {
  MeshFormat format = MeshFormat::Ply;
  std::uint64_t polygonCount = 0;         ///< polygons in the file, the skipped ones included
  std::uint64_t skippedPolygonCount = 0;  ///< all of them
  std::vector<SkippedPolygon> skipped;    ///< the first few
};

/// Reads a model into one mesh: PLY (ASCII, binary little and big endian), STL (ASCII and binary)
/// or OBJ (all its objects and groups together).
///
/// Polygons with more than three corners are cut into a fan of triangles that remember their source
/// (`TriangleMesh::sourceFace` is the polygon's index in the file). Coordinates are rounded to T.
/// A polygon with fewer than three corners or with a vertex index out of range is skipped and
/// counted; the others keep their source index. Vertices that are not finite are kept: the tree
/// skips and counts the faces that use them. Equal corners of STL facets become one vertex.
///
/// Throws `Error` with `FileNotReadable` (missing, a folder, no permission), `UnknownFormat`, or
/// `MalformedFile` (truncated, counts larger than the file can hold, not a number), naming the file
/// and, in text formats, the line. A file without polygons gives an empty mesh. Any thread may call
/// it. Time and memory grow linearly with the file, whatever its header claims.
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
