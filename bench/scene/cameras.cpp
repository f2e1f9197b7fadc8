#include "bench/scene/cameras.hpp"

#include "render/value_percentile.hpp"

#include <planetree/geometry/box3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace planetree::bench {

namespace {

constexpr double kLowerPercentile = 0.02;
constexpr double kUpperPercentile = 0.98;
constexpr float kFovDegrees = 40.0f;
constexpr Vec3d kTowardEye = {0.55, 0.35, 0.76};

struct NamedCamera {
  const char* scene;
  render::Camera camera;
};

constexpr Vec3f kUp = {0.0f, 1.0f, 0.0f};

constexpr std::array<NamedCamera, 5> kNamedCameras = {{
    {"sibenik", {{-15.0f, -9.0f, 0.5f}, {10.0f, -7.0f, -1.0f}, kUp, 70.0f}},
    {"sponza", {{-6.8f, 1.6f, -0.25f}, {5.0f, 2.6f, 0.0f}, kUp, 70.0f}},
    {"kitchen", {{1.2f, 1.7f, 3.8f}, {-0.3f, 1.2f, -2.0f}, kUp, 60.0f}},
    {"conference_clean", {{1300.0f, 420.0f, -700.0f}, {-200.0f, 100.0f, 100.0f}, kUp, 60.0f}},
    {"generated_interior", {{-10.5f, 1.7f, 0.6f}, {8.0f, 2.4f, -0.4f}, kUp, 70.0f}},
}};

Box3 percentileBox(std::span<const Vec3f> positions) {
  Box3 box;
  std::vector<float> values(positions.size());
  for (const Axis axis : kAxes) {
    std::transform(positions.begin(), positions.end(), values.begin(),
                   [axis](const Vec3f& position) { return position[axis]; });
    box.lower[axis] = render::valuePercentile(values, kLowerPercentile);
    box.upper[axis] = render::valuePercentile(values, kUpperPercentile);
  }
  return box;
}

Vec3d boxCorner(const Box3& box, unsigned corner) {
  return {static_cast<double>(corner & 1u ? box.upper.x : box.lower.x),
          static_cast<double>(corner & 2u ? box.upper.y : box.lower.y),
          static_cast<double>(corner & 4u ? box.upper.z : box.lower.z)};
}

}  // namespace

render::Camera framingCamera(std::span<const Vec3f> positions) {
  std::vector<Vec3f> finite;
  std::copy_if(positions.begin(), positions.end(), std::back_inserter(finite),
               [](const Vec3f& position) { return isFinite(position); });
  if (finite.empty())
    return {};
  const Box3 box = percentileBox(finite);
  const Vec3d centre = (boxCorner(box, 0) + boxCorner(box, 7)) * 0.5;
  const render::CameraAxes axes = render::cameraAxes(-kTowardEye, Vec3d(kUp));
  const double slope = std::tan(static_cast<double>(kFovDegrees) * std::numbers::pi / 360.0);

  // A corner is in the picture if its offset to the side is at most `slope` times its depth.
  double distance = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3d fromCentre = boxCorner(box, corner) - centre;
    const double offset =
        std::max(std::fabs(dot(fromCentre, axes.right)), std::fabs(dot(fromCentre, axes.up)));
    distance = std::max(distance, offset / slope - dot(fromCentre, axes.forward));
  }
  // A model that is one point is looked at from anywhere but there.
  if (distance == 0.0)
    distance = 1.0;
  return {Vec3f(centre - axes.forward * distance), Vec3f(centre), kUp, kFovDegrees};
}

render::Camera sceneCamera(const std::string& scene, std::span<const Vec3f> positions) {
  for (const NamedCamera& named : kNamedCameras) {
    if (scene == named.scene)
      return named.camera;
  }
  return framingCamera(positions);
}

}  // namespace planetree::bench
