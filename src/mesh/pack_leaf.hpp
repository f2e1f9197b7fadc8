#pragma once

#include <planetree/detail/object_range.hpp>
#include <planetree/detail/tree_data.hpp>

#include "mesh/leaf_triangles.hpp"
#include "node/leaf_packer.hpp"

#include <span>

namespace planetree::detail {

/// Whether the objects of a geometry are faces that go into blocks.
template <class T>
[[nodiscard]] bool isTriangleMesh(const GeometryEntry<T>& geometry) noexcept {
  return geometry.intersecting == &faceIntersectionTable<T>();
}

/// Packs leaves that hold nothing but faces of meshes. Blocks have room for float: corners in
/// double are put relative to `center`, which leaves no more to round off than needs be, and
/// rounded to nearest. Those that round to the same position share it. The geometries must outlive
/// the packer.
template <class T>
class FacePacker final : public LeafPacker {
 public:
  FacePacker(std::span<const GeometryEntry<T>> geometries, const Vec3f& center) noexcept
      : geometries_(geometries), center_(static_cast<Vec3<T>>(center)) {}

  bool open(std::span<const std::uint32_t> objects) override;
  void countBlocks(std::span<const std::uint32_t> places,
                   std::span<std::uint32_t> counts) override {
    triangles_.countBlocks(places, counts);
  }
  [[nodiscard]] TriangleBlock pack(std::span<const std::uint32_t> places) override {
    return triangles_.pack(places);
  }

 private:
  std::span<const GeometryEntry<T>> geometries_;
  Vec3<T> center_;
  LeafTriangles triangles_;
};
extern template class FacePacker<float>;
extern template class FacePacker<double>;

}  // namespace planetree::detail
