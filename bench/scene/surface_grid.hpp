#pragma once

#include <planetree/geometry/vec3.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace planetree::bench {

/// Adds the surface `point(u, v)` over the unit square, cut into columns times rows squares of two
/// triangles each.
template <class Surface>
void addSurface(TriangleMesh<float>& mesh, std::uint32_t columns, std::uint32_t rows,
                const Surface& point) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t row = 0; row <= rows; ++row) {
    for (std::uint32_t column = 0; column <= columns; ++column) {
      mesh.positions.push_back(Vec3f(
          Vec3d(point(static_cast<double>(column) / columns, static_cast<double>(row) / rows))));
    }
  }
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t corner = first + row * (columns + 1) + column;
      const std::uint32_t above = corner + columns + 1;
      mesh.faces.push_back({corner, corner + 1, above + 1});
      mesh.faces.push_back({corner, above + 1, above});
    }
  }
}

/// The point of a circle around the y axis; `turn` is 1 for the whole circle.
[[nodiscard]] inline Vec3d onCircle(double radius, double turn, double y) {
  const double angle = 2.0 * std::numbers::pi * turn;
  return {radius * std::cos(angle), y, radius * std::sin(angle)};
}

}  // namespace planetree::bench
