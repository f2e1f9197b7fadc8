#include "render/camera.hpp"

#include <cmath>
#include <numbers>

namespace planetree::render {

namespace {

/// The coordinate axis that is farthest from parallel to `direction`.
Vec3d leastParallelAxis(const Vec3d& direction) noexcept {
  Axis least = Axis::X;
  for (const Axis axis : kAxes) {
    if (std::fabs(direction[axis]) < std::fabs(direction[least]))
      least = axis;
  }
  Vec3d unit;
  unit[least] = 1.0;
  return unit;
}

}  // namespace

CameraAxes cameraAxes(const Vec3d& forward, const Vec3d& up) noexcept {
  const Vec3d ahead = normalized(forward);
  Vec3d right = cross(ahead, normalized(up));
  // The length is the sine of the angle between the two. A float carries directions to about 1e-7:
  // below ten times that, `right` would be made of rounding errors.
  if (!(length(right) > 1e-6))
    right = cross(ahead, leastParallelAxis(ahead));
  right = normalized(right);
  return {right, cross(right, ahead), ahead};
}

PinholeCamera::PinholeCamera(const Camera& camera, double aspect) noexcept
    : eye_(camera.eye),
      axes_(cameraAxes(Vec3d(camera.at) - Vec3d(camera.eye), Vec3d(camera.up))),
      halfHeight_(std::tan(static_cast<double>(camera.fovDegrees) * std::numbers::pi / 360.0)) {
  frame_ = axes_;
  dual_ = axes_;
  halfWidth_ = halfHeight_ * aspect;
  viewHeight_ = 2.0 * halfHeight_;
}

PinholeCamera::PinholeCamera(const scene::View& view) noexcept
    : eye_(view.eye),
      axes_(cameraAxes(view.look, view.v)),
      frame_{view.u, view.v, view.look},
      depthScale_(length(view.look)),
      halfWidth_(0.5),
      halfHeight_(0.5),
      viewHeight_(length(view.v) / depthScale_) {
  const double volume = dot(frame_.right, cross(frame_.up, frame_.forward));
  dual_ = {cross(frame_.up, frame_.forward) / volume, cross(frame_.forward, frame_.right) / volume,
           cross(frame_.right, frame_.up) / volume};
}

Rayf PinholeCamera::ray(double x, double y) const noexcept {
  const Vec3d direction = frame_.forward + frame_.right * ((2.0 * x - 1.0) * halfWidth_) +
                          frame_.up * ((1.0 - 2.0 * y) * halfHeight_);
  return {.origin = eye_, .direction = Vec3f(normalized(direction))};
}

Vec3d PinholeCamera::viewCoordinates(const Vec3d& point) const noexcept {
  const Vec3d fromEye = point - Vec3d(eye_);
  const Vec3d place{dot(fromEye, dual_.right) / halfWidth_, dot(fromEye, dual_.up) / halfHeight_,
                    dot(fromEye, dual_.forward)};
  return place * depthScale_;
}

}  // namespace planetree::render
