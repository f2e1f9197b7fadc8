#include "scene/scene_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace planetree::scene {
namespace {

/// Extends the box by what the shapes are after they were placed.
class PlacedBounds {
 public:
  PlacedBounds(const Affine& placement, Box3& box) : placement_(placement), box_(box) {}

  void operator()(const UnitSphere&) { extend({-1, -1, -1}, {1, 1, 1}); }
  void operator()(const UnitBox&) { extend({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}); }
  void operator()(const UnitSquare&) { extend({-0.5, -0.5, 0}, {0.5, 0.5, 0}); }
  void operator()(const UnitCylinder&) { extend({-1, -1, 0}, {1, 1, 1}); }
  void operator()(const ConeShape& cone) {
    const double radius = std::max(std::fabs(cone.bottomRadius), std::fabs(cone.topRadius));
    extend({-radius, -radius, 0}, {radius, radius, cone.height});
  }
  void operator()(const std::shared_ptr<const MeshShape>& mesh) {
    if (!mesh)
      return;
    for (const Vec3d& position : mesh->positions)
      extend(position);
  }

 private:
  void extend(const Vec3d& lower, const Vec3d& upper) {
    for (const double x : {lower.x, upper.x}) {
      for (const double y : {lower.y, upper.y}) {
        extend({x, y, lower.z});
        extend({x, y, upper.z});
      }
    }
  }

  void extend(const Vec3d& point) {
    const Vec3d placed = placement_.point(point);
    if (std::isfinite(placed.x) && std::isfinite(placed.y) && std::isfinite(placed.z))
      box_.extend(placed);
  }

  const Affine& placement_;
  Box3& box_;
};

}  // namespace

Box3 boundsOf(const SceneDescription& scene) {
  Box3 box;
  for (const PlacedShape& placed : scene.shapes)
    std::visit(PlacedBounds(placed.placement, box), placed.shape);
  return box;
}

}  // namespace planetree::scene
