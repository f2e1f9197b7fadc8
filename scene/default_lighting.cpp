#include "scene/default_lighting.hpp"

#include "scene/scene_bounds.hpp"

#include <cmath>

namespace planetree::scene {
namespace {

constexpr double kKey = 0.65;
constexpr double kFill = 0.2;
constexpr double kAmbient = 0.15;

/// Where the viewer's sides are; unit vectors.
struct ViewerAxes {
  Vec3d right;
  Vec3d up;
  Vec3d back;
};

ViewerAxes axesOf(const std::optional<View>& view) {
  if (view)
    return {normalized(view->u), normalized(view->v), -normalized(view->look)};
  const Vec3d back = normalized(Vec3d{0.55, 0.35, 0.76});
  const Vec3d right = normalized(cross(Vec3d{0, 1, 0}, back));
  return {right, cross(back, right), back};
}

bool isInside(const Vec3d& point, const Box3& box) noexcept {
  for (const Axis axis : kAxes) {
    if (!(point[axis] > static_cast<double>(box.lower[axis]) &&
          point[axis] < static_cast<double>(box.upper[axis])))
      return false;
  }
  return true;
}

PointLight lightAt(const Vec3d& position, double brightness) noexcept {
  return {.position = position,
          .colour = {brightness, brightness, brightness},
          .constant = 1.0,
          .linear = 0.0,
          .quadratic = 0.0};
}

}  // namespace

bool addDefaultLighting(SceneDescription& scene) {
  if (!scene.pointLights.empty() || !scene.directionalLights.empty() ||
      !(scene.ambientLight == Vec3d{}))
    return false;

  const Box3 box = boundsOf(scene);
  Vec3d middle{0, 0, 0};
  double radius = 1.0;
  if (!box.isEmpty()) {
    middle = (Vec3d(box.lower) + Vec3d(box.upper)) * 0.5;
    radius = length(Vec3d(box.upper) - Vec3d(box.lower)) * 0.5;
  }
  const auto [right, up, back] = axesOf(scene.view);
  Vec3d key;
  Vec3d fill;
  if (scene.view && isInside(scene.view->eye, box)) {
    key = scene.view->eye + (up - right) * (0.05 * radius);
    fill = middle;
  } else {
    // Far enough that its light comes from much the same side everywhere.
    constexpr double kDistance = 4.0;
    key = middle + normalized(back * 0.6 + up * 0.8 - right * 0.6) * (kDistance * radius);
    fill = middle + normalized(back * 0.7 + up * 0.1 + right * 0.8) * (kDistance * radius);
  }
  scene.pointLights = {lightAt(key, kKey), lightAt(fill, kFill)};
  scene.ambientLight = {kAmbient, kAmbient, kAmbient};
  scene.hasDefaultLighting = true;
  return true;
}

}  // namespace planetree::scene
