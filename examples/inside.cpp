// Whether a point is inside a closed mesh: by the crossings of a ray, whatever it meets on its way.
#include <planetree/planetree.hpp>

#include <array>
#include <cstddef>
#include <cstdio>

using Tree = planetree::KdTree<planetree::Face<double>>;

/// How often the mesh winds around the point: along any ray, each way out counts 1 and each way in
/// -1. A ray may have any number of crossings; they come in portions.
int windingNumber(const Tree& tree, const planetree::Vec3d& point) {
  const planetree::QueryOptions options{.crossings = true};
  const planetree::Rayd ray{.origin = point, .direction = {0, 0, 1}};
  std::array<planetree::Hitd, 8> hits;
  planetree::FoundHits found = tree.findIntersections(ray, hits, options);
  int number = 0;
  while (true) {
    for (std::size_t i = 0; i < found.count; ++i)
      number += dot(hits[i].normal, ray.direction) > 0 ? 1 : -1;
    if (!found.hasMore)
      return number;
    found = tree.findNextIntersections(ray, hits.back(), hits, options);
  }
}

int main() {
  // An octahedron. The ray from its center leaves through the vertex where four faces meet.
  const planetree::TriangleMesh<double> mesh{
      .positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      .faces =
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
      .sourceFaces = {}};
  const Tree tree = planetree::buildTree(mesh.view());
  const int center = windingNumber(tree, {0, 0, 0});
  const int below = windingNumber(tree, {0, 0, -2});
  const int aside = windingNumber(tree, {1, 0, -2});  // its ray touches the vertex at x = 1
  std::printf("center: %d, below: %d, aside: %d\n", center, below, aside);
  return center == 1 && below == 0 && aside == 0 ? 0 : 1;
}
