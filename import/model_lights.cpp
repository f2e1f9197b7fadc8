#include "import/model_lights.hpp"

#include "scene/scene_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace planetree::importing {
namespace {

using scene::DirectionalLight;
using scene::PointLight;
using scene::SceneDescription;

/// Neither below zero nor so large that sums of such numbers overflow.
bool isSound(const Vec3d& v) noexcept {
  constexpr double kMost = 1e15;
  return isFinite(v) && v.x >= 0.0 && v.y >= 0.0 && v.z >= 0.0 && v.x < kMost && v.y < kMost &&
         v.z < kMost;
}

bool isPhotometric(LightKind kind) noexcept {
  return kind == LightKind::PhotometricPoint || kind == LightKind::PhotometricDirectional ||
         kind == LightKind::PhotometricSpot;
}

bool isDirectional(LightKind kind) noexcept {
  return kind == LightKind::Directional || kind == LightKind::PhotometricDirectional;
}

bool isUsable(const ModelLight& light) noexcept {
  if (!isSound(light.colour))
    return false;
  if (light.kind == LightKind::Ambient)
    return true;
  if (isDirectional(light.kind))
    return isFinite(light.direction) && length(light.direction) > 0.0 &&
           std::isfinite(length(light.direction));
  return isFinite(light.position) && isSound(light.attenuation);
}

double most(const Vec3d& colour) noexcept {
  return std::max({colour.x, colour.y, colour.z});
}

void addRemark(SceneDescription& scene, const std::string& remark) {
  const auto end = scene.remarks.end();
  if (std::find(scene.remarks.begin(), end, remark) == end)
    scene.remarks.push_back(remark);
}

/// The middle of the scene, and how large it is.
struct Extent {
  Vec3d middle{0, 0, 0};
  double diagonal = 1.0;
};

Extent extentOf(const SceneDescription& scene) {
  const Box3 box = boundsOf(scene);
  if (box.isEmpty())
    return {};
  const double diagonal = length(Vec3d(box.upper) - Vec3d(box.lower));
  return {(Vec3d(box.lower) + Vec3d(box.upper)) * 0.5, diagonal > 0.0 ? diagonal : 1.0};
}

/// Light that falls off with the square of the distance, in units of one at distance 1. The falling
/// off of a `PointLight` ends where it would be larger than 1. So that this happens only next to
/// the light, whatever the unit of length, it is measured in hundredths of the scene.
PointLight pointSource(const ModelLight& light, double diagonal) noexcept {
  const double unit = 1.0 / (0.01 * diagonal * 0.01 * diagonal);
  return {.position = light.position,
          .colour = light.colour * unit,
          .constant = 0.0,
          .linear = 0.0,
          .quadratic = unit};
}

/// How bright a white surface in the middle of the scene would be by this light alone. A light
/// inside the scene is taken to be farther from what it is meant for.
double brightnessOf(const PointLight& light, const Extent& extent) noexcept {
  const double d = std::max(length(light.position - extent.middle), 0.25 * extent.diagonal);
  const double fall = light.constant + d * (light.linear + d * light.quadratic);
  return most(light.colour) * std::min(1.0, 1.0 / fall);
}

void expose(SceneDescription& scene, const Extent& extent, bool mayBrighten) {
  double brightest = 0.0;
  for (const PointLight& light : scene.pointLights)
    brightest = std::max(brightest, brightnessOf(light, extent));
  for (const DirectionalLight& light : scene.directionalLights)
    brightest = std::max(brightest, most(light.colour));
  if (!(brightest > 1.0 || (mayBrighten && brightest > 0.0)))
    return;
  if (!mayBrighten)
    addRemark(scene, "the lights are too bright for a picture, and were dimmed together");
  for (PointLight& light : scene.pointLights)
    light.colour = light.colour / brightest;
  for (DirectionalLight& light : scene.directionalLights)
    light.colour = light.colour / brightest;
}

void addLight(const ModelLight& light, const Extent& extent, SceneDescription& scene) {
  if (light.kind == LightKind::Ambient) {
    scene.ambientLight = scene.ambientLight + light.colour;
  } else if (isDirectional(light.kind)) {
    scene.directionalLights.push_back({light.direction, light.colour});
  } else if (isPhotometric(light.kind)) {
    scene.pointLights.push_back(pointSource(light, extent.diagonal));
  } else {
    scene.pointLights.push_back({.position = light.position,
                                 .colour = light.colour,
                                 .constant = light.attenuation.x,
                                 .linear = light.attenuation.y,
                                 .quadratic = light.attenuation.z});
  }
  if (light.kind == LightKind::Spot || light.kind == LightKind::PhotometricSpot)
    addRemark(scene, "spot lights shine to all sides here");
  if (light.kind == LightKind::Area)
    addRemark(scene, "area lights shine from one point here");
}

}  // namespace

void addLights(std::span<const ModelLight> lights, SceneDescription& scene) {
  const Extent extent = extentOf(scene);
  bool isMeasured = false;
  bool hasAmbient = false;
  for (const ModelLight& light : lights) {
    if (!isUsable(light)) {
      addRemark(scene, "a light with impossible numbers is left out");
      continue;
    }
    addLight(light, extent, scene);
    isMeasured = isMeasured || isPhotometric(light.kind);
    hasAmbient = hasAmbient || light.kind == LightKind::Ambient;
  }
  expose(scene, extent, isMeasured);
  const bool isLit = !scene.pointLights.empty() || !scene.directionalLights.empty();
  constexpr double kAmbient = 0.1;
  if (isLit && !hasAmbient)
    scene.ambientLight = {kAmbient, kAmbient, kAmbient};
}

std::optional<scene::View> viewOf(const ModelCamera& camera) noexcept {
  const double aspect = camera.aspect == 0.0 ? 1.0 : camera.aspect;
  const double width = 2.0 * std::tan(camera.angleAcross / 2.0);
  if (!(camera.angleAcross > 0.0 && camera.angleAcross < std::numbers::pi) ||
      !(aspect >= 1e-3 && aspect <= 1e3))
    return std::nullopt;
  scene::View view;
  view.eye = camera.position;
  view.look = normalized(camera.direction);
  const Vec3d right = normalized(cross(view.look, camera.up));
  view.u = right * width;
  view.v = cross(right, view.look) * (width / aspect);
  // A vector without a direction comes back from `normalized` as it is.
  const bool hasAxes = length(view.look) > 0.5 && length(right) > 0.5;
  if (!hasAxes || !isFinite(view.eye) || !isFinite(view.u) || !isFinite(view.v))
    return std::nullopt;
  return view;
}

}  // namespace planetree::importing
