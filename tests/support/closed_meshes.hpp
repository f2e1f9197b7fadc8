#pragma once

#include <planetree/mesh/triangle_mesh.hpp>

#include "support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

/// Closed meshes made in code, all star-shaped around the origin: a ray from near the origin must
/// hit each of them, whatever it is aimed at.
namespace planetree::test {

template <class T>
struct ClosedMesh {
  std::string name;
  TriangleMesh<T> mesh;
  Vec3<T> center;  ///< inside
  T innerRadius;   ///< of a ball around the center that lies well inside
};

/// Cuts every triangle into four; `place` puts the middle of two corners where it belongs.
template <class Place>
TriangleMesh<double> subdivide(const TriangleMesh<double>& mesh, Place&& place) {
  TriangleMesh<double> finer;
  finer.positions = mesh.positions;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middleOf = [&](std::uint32_t a, std::uint32_t b) {
    const std::pair<std::uint32_t, std::uint32_t> edge = std::minmax(a, b);
    const auto [entry, isNew] =
        middles.try_emplace(edge, static_cast<std::uint32_t>(finer.positions.size()));
    if (isNew)
      finer.positions.push_back(place((mesh.positions[a] + mesh.positions[b]) * 0.5));
    return entry->second;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    const std::uint32_t ab = middleOf(a, b);
    const std::uint32_t bc = middleOf(b, c);
    const std::uint32_t ca = middleOf(c, a);
    finer.faces.insert(finer.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return finer;
}

inline TriangleMesh<double> octahedron() {
  return {
      .positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      .faces =
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
      .sourceFaces = {}};
}

inline TriangleMesh<double> icosahedron() {
  const double g = std::numbers::phi;
  TriangleMesh<double> mesh{
      .positions = {{-1, g, 0},
                    {1, g, 0},
                    {-1, -g, 0},
                    {1, -g, 0},
                    {0, -1, g},
                    {0, 1, g},
                    {0, -1, -g},
                    {0, 1, -g},
                    {g, 0, -1},
                    {g, 0, 1},
                    {-g, 0, -1},
                    {-g, 0, 1}},
      .faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}},
      .sourceFaces = {}};
  for (Vec3d& position : mesh.positions)
    position = normalized(position);
  return mesh;
}

/// A cube from -1 to 1, each side a grid of n x n squares: vertices lie on two and three planes
/// that a tree is bound to split at.
inline TriangleMesh<double> gridCube(int n) {
  TriangleMesh<double> mesh;
  std::map<std::array<int, 3>, std::uint32_t> vertices;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [entry, isNew] =
        vertices.try_emplace(at, static_cast<std::uint32_t>(mesh.positions.size()));
    if (isNew) {
      const auto coordinate = [n](int i) { return 2.0 * i / n - 1.0; };
      mesh.positions.push_back({coordinate(at[0]), coordinate(at[1]), coordinate(at[2])});
    }
    return entry->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int u, int v) {
            std::array<int, 3> position{};
            position[axis] = side;
            position[(axis + 1) % 3] = u;
            position[(axis + 2) % 3] = v;
            return vertex(position);
          };
          const std::uint32_t a = at(i, j);
          const std::uint32_t b = at(i + 1, j);
          const std::uint32_t c = at(i + 1, j + 1);
          const std::uint32_t d = at(i, j + 1);
          if (side == n) {
            mesh.faces.insert(mesh.faces.end(), {{a, b, c}, {a, c, d}});
          } else {
            mesh.faces.insert(mesh.faces.end(), {{a, c, b}, {a, d, c}});
          }
        }
      }
    }
  }
  return mesh;
}

/// The same mesh scaled and moved, rounded to T: the rounded mesh is what the rays must hit.
template <class T>
ClosedMesh<T> placed(std::string name, const TriangleMesh<double>& mesh, double scale,
                     const Vec3d& offset, double innerRadius) {
  ClosedMesh<T> result;
  result.name = std::move(name);
  result.mesh.faces = mesh.faces;
  for (const Vec3d& position : mesh.positions) {
    result.mesh.positions.push_back(static_cast<Vec3<T>>(position * scale + offset));
  }
  result.center = static_cast<Vec3<T>>(offset);
  result.innerRadius = static_cast<T>(innerRadius * scale);
  return result;
}

/// The list of closed meshes that leak tests share.
template <class T>
std::vector<ClosedMesh<T>> closedMeshes() {
  TriangleMesh<double> sphere = icosahedron();
  TriangleMesh<double> octasphere = octahedron();
  for (int level = 0; level < 4; ++level) {
    sphere = subdivide(sphere, [](const Vec3d& p) { return normalized(p); });
    octasphere = subdivide(octasphere, [](const Vec3d& p) { return normalized(p); });
  }

  Random random(1);
  TriangleMesh<double> star = sphere;
  for (Vec3d& position : star.positions)
    position = position * random.between(0.5, 1.5);

  // Faces a million times longer than wide.
  TriangleMesh<double> needle = gridCube(8);
  for (Vec3d& position : needle.positions)
    position = {position.x * 1e3, position.y, position.z * 1e-3};

  std::vector<ClosedMesh<T>> meshes;
  meshes.push_back(placed<T>("icosphere", sphere, 1.0, {}, 0.7));
  meshes.push_back(placed<T>("octasphere", octasphere, 1.0, {}, 0.4));
  meshes.push_back(placed<T>("grid cube", gridCube(16), 1.0, {}, 0.7));
  meshes.push_back(placed<T>("star", star, 1.0, {}, 0.1));
  meshes.push_back(placed<T>("needle box", needle, 1.0, {}, 5e-4));
  meshes.push_back(placed<T>("far icosphere", sphere, 1.0, {1e4, -3e4, 2e4}, 0.5));
  meshes.push_back(placed<T>("tiny star", star, 0x1p-30, {}, 0.1));
  meshes.push_back(placed<T>("huge cube", gridCube(16), 0x1p30, {}, 0.7));
  return meshes;
}

}  // namespace planetree::test
