#include "mesh/place_triangles.hpp"

#include "mesh/pack_triangles.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>

namespace planetree::detail {
namespace {

/// Adds blocks with all objects of a leaf; false if one of them is no face of a mesh.
template <class T>
bool packLeaf(std::span<const GeometryEntry<T>> geometries,
              std::span<const std::uint32_t> references, const Vec3f& center,
              std::vector<TriangleBlock>& blocks) {
  while (!references.empty()) {
    const GeometryEntry<T>& geometry = geometries[geometryOf(geometries, references.front())];
    if (!isTriangleMesh(geometry))
      return false;
    const std::uint64_t end = std::uint64_t{geometry.firstObject} + geometry.size;
    const auto run = std::partition_point(references.begin(), references.end(),
                                          [&](std::uint32_t object) { return object < end; });
    const auto count = static_cast<std::size_t>(run - references.begin());
    const auto& mesh = *static_cast<const TriangleMeshView<T>*>(geometry.range);
    const auto faces = references.first(count);
    if constexpr (std::is_same_v<T, float>)
      packTriangles(mesh, faces, geometry.firstObject, blocks);
    else
      packRoundedTriangles(mesh, faces, geometry.firstObject, center, blocks);
    references = references.subspan(count);
  }
  return true;
}

}  // namespace

template <class T>
PlaceLeaf placeTriangles(const TreeData<T>& tree) {
  const Vec3f center = centerOfWideTree(tree.bounds);
  return [&tree, center](std::uint32_t leafIndex, std::vector<TriangleBlock>& blocks) {
    const LeafNode& leaf = tree.nodes[leafIndex].leaf();
    const std::size_t first = blocks.size();
    const auto references = std::span(tree.references).subspan(leaf.firstReference(), leaf.count());
    const bool isPacked = packLeaf<T>(tree.geometries, references, center, blocks);
    const std::size_t count = blocks.size() - first;
    if (!isPacked || count > WideChild::kMaxBlockCount ||
        blocks.size() > WideChild::kMaxBlockIndex) {
      blocks.resize(first);
      return WideChild::objects(leafIndex);
    }
    return WideChild::blocks(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count));
  };
}

template PlaceLeaf placeTriangles(const TreeData<float>&);
template PlaceLeaf placeTriangles(const TreeData<double>&);

}  // namespace planetree::detail
