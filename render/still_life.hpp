#pragma once

#include <planetree/geometry/vec3.hpp>
#include <planetree/mesh/triangle_mesh.hpp>
#include <planetree/scene.hpp>

#include <vector>

namespace planetree::render {

/// A scene that needs no file: shapes of every kind and a triangle mesh, all in one tree. It has y
/// up.
struct StillLife {
  Scene<float> scene;
  std::vector<Vec3f> albedos;  ///< the colour of each geometry, in linear light
  std::vector<Vec3f> outline;  ///< points around it, to frame it by
};

/// Always the same scene.
[[nodiscard]] StillLife makeStillLife();

/// The (2, 3) torus knot as a closed tube around the origin, about 2 wide in each direction of the
/// plane z = 0: `segments` rings of `sides` corners each.
[[nodiscard]] TriangleMesh<float> makeTorusKnot(std::uint32_t segments, std::uint32_t sides,
                                                double tubeRadius);

}  // namespace planetree::render
