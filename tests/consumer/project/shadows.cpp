#include "shadows.hpp"

#include <memory>
#include <utility>
#include <vector>

bool isInShadow(const planetree::Vec3f& point, const planetree::Vec3f& light) {
  std::vector<std::unique_ptr<planetree::Geometry<float>>> shapes;
  shapes.push_back(planetree::makeGeometry(planetree::Sphere<float>{{0, 0, 0}, 1}));
  const auto tree = planetree::buildTree(std::move(shapes));
  return tree.isOccluded({.origin = point, .direction = light - point, .tMax = 1});
}
