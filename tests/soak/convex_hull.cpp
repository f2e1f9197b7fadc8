#include "soak/convex_hull.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace planetree::test {
namespace {

bool sees(const Vec3d& point, const FaceIndices& face, std::span<const Vec3d> points) {
  const Vec3d a = points[face[0]];
  return dot(cross(points[face[1]] - a, points[face[2]] - a), point - a) > 0.0;
}

/// The faces that the point sees give way to a cone from their rim to the point.
void addPoint(std::uint32_t point, std::span<const Vec3d> points, std::vector<FaceIndices>& faces) {
  const auto firstSeen = std::partition(faces.begin(), faces.end(), [&](const FaceIndices& face) {
    return !sees(points[point], face, points);
  });
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (auto face = firstSeen; face != faces.end(); ++face) {
    for (std::size_t i = 0; i < 3; ++i)
      edges.insert({(*face)[i], (*face)[(i + 1) % 3]});
  }
  faces.erase(firstSeen, faces.end());
  for (const auto& [from, to] : edges) {
    if (!edges.contains({to, from}))
      faces.push_back({from, to, point});
  }
}

}  // namespace

TriangleMesh<double> convexHull(std::span<const Vec3d> points) {
  std::vector<FaceIndices> faces = {{0, 1, 2}, {0, 2, 1}};
  if (sees(points[3], faces[0], points))
    faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  else
    faces = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  for (std::uint32_t point = 4; point < points.size(); ++point)
    addPoint(point, points, faces);

  // Only corners of faces are kept.
  constexpr std::uint32_t kUnused = 0xFFFF'FFFFu;
  std::vector<std::uint32_t> newNumbers(points.size(), kUnused);
  TriangleMesh<double> hull;
  for (const FaceIndices& face : faces) {
    FaceIndices renumbered{};
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& number = newNumbers[face[i]];
      if (number == kUnused) {
        number = static_cast<std::uint32_t>(hull.positions.size());
        hull.positions.push_back(points[face[i]]);
      }
      renumbered[i] = number;
    }
    hull.faces.push_back(renumbered);
  }
  return hull;
}

}  // namespace planetree::test
