#pragma once

#include <planetree/geometry/vec3.hpp>

namespace planetree::scene {

struct PointLight {
  Vec3d position;
  Vec3d colour;
  /// At distance d the light is min(1, 1 / (constant + linear d + quadratic d^2)).
  double constant = 0.0;
  double linear = 0.0;
  double quadratic = 1.0;
};

/// Light from infinitely far away.
struct DirectionalLight {
  Vec3d direction;  ///< in which it travels; need not have unit length, is not zero
  Vec3d colour;
};

}  // namespace planetree::scene
