#include <planetree/kd_tree.hpp>
#include <planetree/mesh/triangle_mesh.hpp>
#include <planetree/node/validate_tree.hpp>

#include "support/byte_stream.hpp"
#include "support/promise.hpp"

#include <cstring>
#include <vector>

// Any bytes as the nodes of a tree: what `validateTree` accepts, rays can walk.

namespace planetree::fuzz {
namespace {

TriangleMesh<float> eightTriangles() {
  TriangleMesh<float> mesh;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const float x = static_cast<float>(i) / 8.0f;
    mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x, 1, 0}, {x, 0, 1}});
    mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

void check(ByteStream input) {
  static const TriangleMesh<float> mesh = eightTriangles();
  static const TriangleMeshView<float> view = mesh.view();
  Box3 bounds{{0, 0, 0}, {1, 1, 1}};
  if (input.takeBelow(8) == 0)
    bounds = {{input.take<float>(), input.take<float>(), input.take<float>()},
              {input.take<float>(), input.take<float>(), input.take<float>()}};
  std::vector<std::uint32_t> references(input.takeBelow(16));
  for (std::uint32_t& reference : references)
    reference = input.takeBelow(9);
  std::vector<Node> nodes(input.rest().size() / sizeof(Node), Node(LeafNode(0, 0)));
  if (!nodes.empty())
    std::memcpy(static_cast<void*>(nodes.data()), input.rest().data(), nodes.size() * sizeof(Node));
  if (validateTree(nodes, references, bounds, mesh.faces.size()))
    return;

  const KdTree<Face<float>> tree(detail::TreeData<float>{.nodes = nodes,
                                                         .references = references,
                                                         .geometries = {detail::viewedEntry(view)},
                                                         .bounds = bounds,
                                                         .options = {},
                                                         .report = {}});
  for (const Vec3f& direction : {Vec3f{1, 0, 0}, Vec3f{0.3f, 1, -0.5f}, Vec3f{-1, 0.1f, 0}}) {
    const Rayf ray{.origin = {0.5f, 0.2f, 0.2f}, .direction = direction, .tMin = -9};
    const auto hit = tree.findIntersection(ray);
    require(!hit || hit->primitive < mesh.faces.size(), "hits are on objects of the tree");
    require(hit.has_value() == tree.isOccluded(ray), "the nearest hit is one");
  }
  static_cast<void>(tree.statistics());
}

}  // namespace
}  // namespace planetree::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  planetree::fuzz::check(planetree::fuzz::ByteStream(data, size));
  return 0;
}
