#include "mesh/place_triangles.hpp"

#include <planetree/detail/object_range.hpp>

#include "mesh/pack_triangles.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

namespace planetree::detail {
namespace {

/// Adds blocks with all objects of a leaf; false if one of them is no face of a mesh.
bool packLeaf(std::span<const GeometryEntry<float>> geometries,
              std::span<const std::uint32_t> references, std::vector<TriangleBlock>& blocks) {
  while (!references.empty()) {
    const GeometryEntry<float>& geometry = geometries[geometryOf(geometries, references.front())];
    if (!isTriangleMesh(geometry))
      return false;
    const std::uint64_t end = std::uint64_t{geometry.firstObject} + geometry.size;
    const auto run = std::partition_point(references.begin(), references.end(),
                                          [&](std::uint32_t object) { return object < end; });
    const auto count = static_cast<std::size_t>(run - references.begin());
    packTriangles(*static_cast<const TriangleMeshView<float>*>(geometry.range),
                  references.first(count), geometry.firstObject, blocks);
    references = references.subspan(count);
  }
  return true;
}

}  // namespace

bool isTriangleMesh(const GeometryEntry<float>& geometry) noexcept {
  return geometry.intersecting == &faceIntersectionTable<float>();
}

PlaceLeaf placeTriangles(const TreeData<float>& tree) {
  return [&tree](std::uint32_t leafIndex,
                 std::vector<TriangleBlock>& blocks) -> std::optional<WideChild> {
    const LeafNode& leaf = tree.nodes[leafIndex].leaf();
    const std::size_t first = blocks.size();
    const bool isPacked =
        packLeaf(tree.geometries,
                 std::span(tree.references).subspan(leaf.firstReference(), leaf.count()), blocks);
    const std::size_t count = blocks.size() - first;
    if (!isPacked || count > WideChild::kMaxBlockCount ||
        blocks.size() > WideChild::kMaxBlockIndex) {
      blocks.resize(first);
      return std::nullopt;
    }
    return WideChild::blocks(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count));
  };
}

}  // namespace planetree::detail
