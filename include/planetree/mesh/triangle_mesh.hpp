#pragma once

#include <planetree/geometry/vec3.hpp>
#include <planetree/mesh/face.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace planetree {

/// The three vertex indices of a face, counter-clockwise as seen from outside.
using FaceIndices = std::array<std::uint32_t, 3>;

/// A triangle mesh in the caller's own arrays: nothing is copied. The arrays must outlive every
/// tree built from the view, and must not change while one exists.
///
/// Positions are three scalars T each, `positionStride` bytes apart; faces are three 32-bit indices
/// each, `faceStride` bytes apart. Neither needs any alignment.
template <std::floating_point T>
class TriangleMeshView {
  static_assert(std::same_as<T, float> || std::same_as<T, double>);

 public:
  using Scalar = T;

  /// A mesh without faces.
  TriangleMeshView() = default;

  TriangleMeshView(const void* positions, std::size_t positionStride, std::size_t vertexCount,
                   const void* faces, std::size_t faceStride, std::size_t faceCount) noexcept
      : positions_(static_cast<const std::byte*>(positions)),
        positionStride_(positionStride),
        vertexCount_(vertexCount),
        faces_(static_cast<const std::byte*>(faces)),
        faceStride_(faceStride),
        faceCount_(faceCount) {}

  TriangleMeshView(std::span<const Vec3<T>> positions, std::span<const FaceIndices> faces) noexcept
      : TriangleMeshView(positions.data(), sizeof(Vec3<T>), positions.size(), faces.data(),
                         sizeof(FaceIndices), faces.size()) {}

  [[nodiscard]] std::size_t vertexCount() const noexcept { return vertexCount_; }
  [[nodiscard]] std::size_t size() const noexcept { return faceCount_; }
  [[nodiscard]] bool empty() const noexcept { return faceCount_ == 0; }

  /// Position of a vertex; `index` must be below `vertexCount()`.
  [[nodiscard]] Vec3<T> position(std::size_t index) const noexcept {
    T xyz[3];
    std::memcpy(xyz, positions_ + index * positionStride_, sizeof(xyz));
    return {xyz[0], xyz[1], xyz[2]};
  }

  /// Vertex indices of a face as they stand in the array; they may be out of range.
  [[nodiscard]] FaceIndices indices(std::size_t face) const noexcept {
    FaceIndices abc;
    std::memcpy(abc.data(), faces_ + face * faceStride_, sizeof(abc));
    return abc;
  }

  /// The corners of a face whose indices are in range.
  [[nodiscard]] std::array<Vec3<T>, 3> corners(std::size_t face) const noexcept {
    const FaceIndices abc = indices(face);
    return {position(abc[0]), position(abc[1]), position(abc[2])};
  }

  /// The face as an object for a tree. It refers to this view, which must outlive it.
  [[nodiscard]] Face<T> operator[](std::size_t face) const noexcept {
    return Face<T>(*this, static_cast<std::uint32_t>(face));
  }

 private:
  const std::byte* positions_ = nullptr;
  std::size_t positionStride_ = 0;
  std::size_t vertexCount_ = 0;
  const std::byte* faces_ = nullptr;
  std::size_t faceStride_ = 0;
  std::size_t faceCount_ = 0;
};

/// A triangle mesh that owns its arrays. Convex polygons with more than three corners are cut into
/// triangles when they are added, and each triangle remembers the polygon it came from.
template <std::floating_point T>
struct TriangleMesh {
  using Scalar = T;

  std::vector<Vec3<T>> positions;
  std::vector<FaceIndices> faces;
  /// For each face the index of the polygon it was cut from. Empty while every face is its own
  /// source: all polygons were triangles, and none was left out.
  std::vector<std::uint32_t> sourceFaces;

  [[nodiscard]] TriangleMeshView<T> view() const noexcept { return {positions, faces}; }

  /// The index of the polygon that `face` was cut from.
  [[nodiscard]] std::uint32_t sourceFace(std::uint32_t face) const noexcept {
    return sourceFaces.empty() ? face : sourceFaces[face];
  }

  /// Adds a polygon as a fan of triangles around its first corner, which is right for convex ones;
  /// nothing is added for fewer than three corners. `source` is the index of the polygon in the
  /// caller's count; vertex indices are taken as they are. Throws nothing but std::bad_alloc.
  void addPolygon(std::span<const std::uint32_t> corners, std::uint32_t source);
};

extern template struct TriangleMesh<float>;
extern template struct TriangleMesh<double>;

}  // namespace planetree
