#pragma once

#include "mesh/mesh_input.hpp"

#include <planetree/mesh/read_mesh.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace planetree::detail {

/// Collects what a reader finds in a file: vertices, polygons, and what had to be left out.
template <std::floating_point T>
class MeshBuilder {
 public:
  MeshBuilder(const MeshInput& input, MeshFormat format) : input_(&input) {
    report_.format = format;
  }

  void reserveVertices(std::size_t count) { mesh_.positions.reserve(count); }
  void reserveTriangles(std::size_t count) { mesh_.faces.reserve(count); }

  /// Says how many vertices there will be, for polygons that come before them.
  void announceVertices(std::uint64_t count) noexcept { announcedVertexCount_ = count; }

  /// Adds a vertex and returns its index.
  std::uint32_t addVertex(const Vec3<T>& position);

  /// Adds a polygon, or skips it if it has too few corners or one that does not exist. `line` is
  /// where it stands in a text format.
  void addPolygon(std::span<const std::int64_t> corners, std::int64_t line = Error::kNone);

  /// Counts a polygon that cannot be added because it "refers to vertex 0, ...".
  void skipPolygon(const std::string& reason, std::int64_t line = Error::kNone);

  /// Counts points, lines, curves or surfaces.
  void countUnread(std::uint64_t count) noexcept { report_.unreadPrimitiveCount += count; }

  /// Counts coordinates that are finite in the file but not in T.
  void countTooLarge(std::uint64_t count) noexcept { report_.tooLargeCount += count; }

  [[nodiscard]] const std::vector<Vec3<T>>& positions() const noexcept { return mesh_.positions; }
  [[nodiscard]] TriangleMesh<T> takeMesh() noexcept { return std::move(mesh_); }
  [[nodiscard]] MeshReadReport takeReport() noexcept { return std::move(report_); }

 private:
  [[nodiscard]] bool isVertex(std::int64_t index) const noexcept;
  [[nodiscard]] Error tooMany(const std::string& what) const;

  const MeshInput* input_;
  TriangleMesh<T> mesh_;
  MeshReadReport report_;
  std::uint64_t announcedVertexCount_ = 0;
  std::vector<std::uint32_t> corners_;  ///< of the polygon at hand; kept to allocate but once
};

extern template class MeshBuilder<float>;
extern template class MeshBuilder<double>;

/// "refers to vertex 7, which does not exist".
[[nodiscard]] std::string missingVertexReason(std::int64_t index);

}  // namespace planetree::detail
