#pragma once

#include "scene/view.hpp"

#include <planetree/geometry/ray.hpp>
#include <planetree/geometry/vec3.hpp>

namespace planetree::render {

/// Where a picture is taken from.
struct Camera {
  Vec3f eye{0.0f, 0.0f, 1.0f};
  Vec3f at{0.0f, 0.0f, 0.0f};  ///< the point in the middle of the picture
  Vec3f up{0.0f, 1.0f, 0.0f};
  float fovDegrees = 40.0f;  ///< from the lower to the upper edge of the picture
};

/// The axes of a camera, unit vectors at right angles.
struct CameraAxes {
  Vec3d right;
  Vec3d up;
  Vec3d forward;
};

/// The axes of a camera that looks along `forward`. Looking straight up or down is allowed: where
/// `up` does not say which way the picture is turned, a coordinate axis does.
[[nodiscard]] CameraAxes cameraAxes(const Vec3d& forward, const Vec3d& up) noexcept;

/// A pinhole camera for pictures of one aspect ratio. The rays have unit directions.
class PinholeCamera {
 public:
  /// `aspect` is the width of the picture divided by its height. `camera.eye` and `camera.at` must
  /// be different points.
  PinholeCamera(const Camera& camera, double aspect) noexcept;

  /// The camera of a scene: its axes are used as given. They must not lie in one plane.
  explicit PinholeCamera(const scene::View& view) noexcept;

  /// The ray through a point of the picture: x from 0 (left) to 1, y from 0 (top) to 1.
  [[nodiscard]] Rayf ray(double x, double y) const noexcept;

  /// A point as the picture has it: x / z runs from -1 (left) to 1, y / z from -1 (bottom) to 1,
  /// and z is the depth along the view direction.
  [[nodiscard]] Vec3d viewCoordinates(const Vec3d& point) const noexcept;

  /// The height of what the picture shows, at distance 1 from the eye.
  [[nodiscard]] double viewHeight() const noexcept { return viewHeight_; }

  [[nodiscard]] const CameraAxes& axes() const noexcept { return axes_; }

 private:
  Vec3f eye_;
  CameraAxes axes_;
  CameraAxes frame_;         ///< what rays are made of; of any lengths and angles
  CameraAxes dual_;          ///< what views are made of: dot products with `frame_` are 0 or 1
  double depthScale_ = 1.0;  ///< the length of `frame_.forward`
  double halfWidth_;         ///< of the picture, in units of `frame_`
  double halfHeight_;
  double viewHeight_;
};

}  // namespace planetree::render
