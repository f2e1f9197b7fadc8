#pragma once

#include <planetree/geometry/vec3.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <span>

namespace planetree::test {

/// The convex hull of points in general position (random ones are), of which no face has four; its
/// faces run counter-clockwise as seen from outside. Takes a look at every face for each point.
[[nodiscard]] TriangleMesh<double> convexHull(std::span<const Vec3d> points);

}  // namespace planetree::test
