#pragma once

#include <planetree/build_tree.hpp>
#include <planetree/kd_tree.hpp>
#include <planetree/scene.hpp>
#include <planetree/shape/shapes.hpp>

#include "support/closed_meshes.hpp"
#include "support/hard_cases.hpp"
#include "support/random.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// Scenes for batches: what rays that go the same way may have in common, or not.
namespace planetree::test {

template <class T>
struct BatchScene {
  std::string name;
  KdTree<AnyObject<T>> tree;
  TriangleMesh<T> mesh;  ///< what rays can be aimed at
};

/// A box with walls of two triangles each, seen from inside, and some clutter.
template <class T>
TriangleMesh<T> room() {
  TriangleMesh<T> mesh = detail::soup<T>(301, 150, 0.08);
  for (const auto& [a, b, c] : gridCube(1).faces) {
    const auto corner = [](std::uint32_t i) {
      return static_cast<Vec3<T>>(gridCube(1).positions[i] * 2.0);
    };
    detail::addTriangle(mesh, corner(a), corner(b), corner(c));
  }
  return mesh;
}

template <class T>
std::vector<Sphere<T>> someSpheres(std::uint64_t salt, int count) {
  Random random(salt);
  std::vector<Sphere<T>> spheres;
  while (static_cast<int>(spheres.size()) < count)
    spheres.push_back(
        {random.pointIn<T>({-1, -1, -1}, {1, 1, 1}), static_cast<T>(random.between(0.02, 0.2))});
  return spheres;
}

template <class T>
std::vector<BatchScene<T>> batchScenes() {
  std::vector<BatchScene<T>> scenes;
  const auto addScene = [&scenes](std::string name, const Scene<T>& scene, TriangleMesh<T> mesh) {
    scenes.push_back({std::move(name), buildTree(scene), std::move(mesh)});
  };
  const auto addMesh = [&addScene](std::string name, const TriangleMesh<T>& mesh) {
    Scene<T> scene;
    scene.add(mesh);
    addScene(std::move(name), scene, mesh);
  };
  addMesh("nothing", {});
  TriangleMesh<T> one;
  detail::addTriangle(one, Vec3<T>{-1, -1, 0}, Vec3<T>{1, -1, T(0.2)}, Vec3<T>{0, 1, 0});
  addMesh("one triangle", one);

  for (ClosedMesh<T>& closed : closedMeshes<T>())
    addMesh(closed.name, closed.mesh);
  addMesh("soup", detail::soup<T>(302, 3000, 0.05));
  addMesh("room", room<T>());

  const TriangleMesh<T> grid = detail::grid<T>(16, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  TriangleMesh<T> twice = grid;
  detail::append(twice, grid);
  addMesh("every face of a grid twice", twice);

  const TriangleMesh<T> soup = detail::soup<T>(303, 400, 0.2);
  Scene<T> shapes;
  shapes.add(someSpheres<T>(304, 80));
  shapes.add(soup);
  shapes.add(Box<T>{{T(0.2), T(0.2), T(0.2)}, {T(0.6), T(0.5), T(0.4)}});
  addScene("spheres, a mesh and a box", shapes, soup);

  Scene<T> masked;
  masked.add(soup, {.mask = 1});
  masked.add(someSpheres<T>(305, 40), {.mask = 2});
  masked.add(soup, {.mask = 6});
  masked.add(TriangleMesh<T>{}, {.mask = 1});
  masked.add(grid, {.mask = 8});
  addScene("geometries with masks", masked, soup);
  return scenes;
}

}  // namespace planetree::test
