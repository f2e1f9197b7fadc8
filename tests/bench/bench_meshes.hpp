#pragma once

#include "bench/scene/load_scene.hpp"
#include "bench/scene/surface_grid.hpp"

#include <planetree/mesh/triangle_mesh.hpp>

#include <cmath>
#include <numbers>

namespace planetree::test {

/// A closed ball of radius 1 around the origin.
inline TriangleMesh<float> ball() {
  TriangleMesh<float> mesh;
  bench::addSurface(mesh, 24, 12, [](double turn, double v) {
    const double angle = std::numbers::pi * v;
    return bench::onCircle(std::sin(angle), turn, -std::cos(angle));
  });
  return mesh;
}

/// A wavy floor of size 4, hit by every ray from above.
inline TriangleMesh<float> waves() {
  TriangleMesh<float> mesh;
  bench::addSurface(mesh, 40, 40, [](double u, double v) {
    return Vec3d{4.0 * u - 2.0, 0.2 * std::sin(9.0 * u) * std::cos(7.0 * v), 2.0 - 4.0 * v};
  });
  return mesh;
}

inline bench::BenchScene ballScene() {
  return bench::makeScene("ball", ball());
}

}  // namespace planetree::test
