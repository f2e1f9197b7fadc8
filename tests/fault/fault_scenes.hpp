#pragma once

#include "unit/split/random_meshes.hpp"

#include <planetree/planetree.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// What the trees of these tests are made of.
namespace planetree::test {

struct Preset {
  const char* name;
  BuildOptions options;
};

inline const std::array<Preset, 4> kPresets = {{{"fast", BuildOptions::fast()},
                                                {"balanced", BuildOptions::balanced()},
                                                {"high", BuildOptions::high()},
                                                {"textbook", BuildOptions::textbook()}}};

/// One thread builds it alone. Some faces are skipped.
template <class T>
TriangleMesh<T> smallMesh() {
  TriangleMesh<T> mesh = MeshGenerator(3).soupOfAnyCoordinates<T>(120, T(0.3));
  mesh.faces.push_back({0, 0, 1});
  mesh.faces.push_back({0, 1, 1'000'000});
  return mesh;
}

/// Large enough for cells that threads divide together, for subtrees of their own, and for pages
/// that are mapped.
template <class T>
TriangleMesh<T> largeMesh() {
  return MeshGenerator(4).soupOfAnyCoordinates<T>(20'000, T(0.02));
}

template <class T>
std::vector<Ray<T>> someRays(std::size_t count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<T> unit(T(-0.5), T(1.5));
  const auto point = [&] { return Vec3<T>{unit(random), unit(random), unit(random)}; };
  std::vector<Ray<T>> rays;
  while (rays.size() < count) {
    const Vec3<T> origin = point();
    rays.push_back({.origin = origin, .direction = point() - origin});
  }
  return rays;
}

/// Meshes, shapes of several kinds, and shapes behind pointers.
template <class T>
Scene<T> mixedScene(const TriangleMesh<T>& mesh) {
  Scene<T> scene;
  scene.add(mesh.view());
  scene.add(mesh, {.mask = 2});
  std::vector<Sphere<T>> spheres;
  for (int i = 0; i < 40; ++i)
    spheres.push_back({.center = {T(i) / T(40), T(0.5), T(0.5)}, .radius = T(0.05)});
  scene.add(std::move(spheres));
  scene.add(Box<T>{{T(0.25), T(0.25), T(0.25)}, {T(0.5), T(0.75), T(0.5)}});
  std::vector<std::unique_ptr<Geometry<T>>> pointers;
  pointers.push_back(makeGeometry(Sphere<T>{.center = {0, 0, 0}, .radius = T(0.25)}));
  pointers.push_back(nullptr);
  pointers.push_back(makeGeometry(Cone<T>{}));
  scene.add(std::move(pointers));
  return scene;
}

}  // namespace planetree::test
