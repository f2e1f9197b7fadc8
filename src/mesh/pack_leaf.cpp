#include "mesh/pack_leaf.hpp"

#include "geometry/longest_axis.hpp"
#include "mesh/pack_triangles.hpp"
#include "support/sort_by.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>

namespace planetree::detail {
namespace {

/// The faces in an order in which those that follow each other are near each other, along the axis
/// on which they are spread the most: worth it for leaves whose blocks get boxes of their own.
template <class T>
std::vector<std::uint32_t> sortedInSpace(const TriangleMeshView<T>& mesh,
                                         std::span<const std::uint32_t> objects,
                                         std::uint32_t firstObject) {
  const auto lowestCorner = [&](std::uint32_t object) {
    Box3 box;
    for (const Vec3<T>& corner : mesh.corners(object - firstObject))
      box.extend(corner);
    return box.lower;
  };
  Box3 spread;
  for (const std::uint32_t object : objects)
    spread.extend(lowestCorner(object));
  const Axis axis = longestAxis(spread);
  std::vector<std::uint32_t> sorted(objects.begin(), objects.end());
  sortBy(sorted, [&](std::uint32_t object) { return lowestCorner(object)[axis]; });
  return sorted;
}

/// Adds blocks with faces of one mesh.
template <class T>
void packFaces(const GeometryEntry<T>& geometry, std::span<const std::uint32_t> faces,
               const Vec3f& center, std::vector<TriangleBlock>& blocks, std::vector<Box3>& bounds) {
  constexpr std::size_t kManyFaces = 3 * TriangleBlock::kLaneCount;
  const auto& mesh = *static_cast<const TriangleMeshView<T>*>(geometry.range);
  std::vector<std::uint32_t> sorted;
  if (faces.size() > kManyFaces) {
    sorted = sortedInSpace(mesh, faces, geometry.firstObject);
    faces = sorted;
  }
  if constexpr (std::is_same_v<T, float>)
    packTriangles(mesh, faces, geometry.firstObject, blocks, bounds);
  else
    packRoundedTriangles(mesh, faces, geometry.firstObject, center, blocks, bounds);
}

/// Adds blocks with all objects of a leaf; false if one of them is no face of a mesh.
template <class T>
bool packLeaf(std::span<const GeometryEntry<T>> geometries,
              std::span<const std::uint32_t> references, const Vec3f& center,
              std::vector<TriangleBlock>& blocks, std::vector<Box3>& bounds) {
  while (!references.empty()) {
    const GeometryEntry<T>& geometry = geometries[geometryOf(geometries, references.front())];
    if (!isTriangleMesh(geometry))
      return false;
    const std::uint64_t end = std::uint64_t{geometry.firstObject} + geometry.size;
    const auto run = std::partition_point(references.begin(), references.end(),
                                          [&](std::uint32_t object) { return object < end; });
    const auto count = static_cast<std::size_t>(run - references.begin());
    packFaces(geometry, references.first(count), center, blocks, bounds);
    references = references.subspan(count);
  }
  return true;
}

}  // namespace

template <class T>
PackLeaf packTrianglesOf(const TreeData<T>& tree) {
  const Vec3f center = centerOfWideTree(tree.bounds);
  return [&tree, center](std::uint32_t leafIndex, std::vector<TriangleBlock>& blocks,
                         std::vector<Box3>& bounds) {
    const LeafNode& leaf = tree.nodes[leafIndex].leaf();
    const std::size_t first = blocks.size();
    const auto references = std::span(tree.references).subspan(leaf.firstReference(), leaf.count());
    const bool isPacked = packLeaf<T>(tree.geometries, references, center, blocks, bounds);
    if (!isPacked) {
      blocks.resize(first);
      bounds.clear();
    }
    return isPacked;
  };
}

template PackLeaf packTrianglesOf(const TreeData<float>&);
template PackLeaf packTrianglesOf(const TreeData<double>&);

}  // namespace planetree::detail
