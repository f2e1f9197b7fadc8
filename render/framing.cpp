#include "render/framing.hpp"

#include "render/value_percentile.hpp"

#include <planetree/geometry/box3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>

namespace planetree::render {

namespace {

constexpr double kLowerPercentile = 0.02;
constexpr double kUpperPercentile = 0.98;

/// The part of the picture's half width and height that the model may fill.
constexpr double kFill = 0.92;

std::vector<Vec3f> finitePoints(std::span<const Vec3f> points) {
  std::vector<Vec3f> finite;
  finite.reserve(points.size());
  std::copy_if(points.begin(), points.end(), std::back_inserter(finite),
               [](const Vec3f& point) { return isFinite(point); });
  return finite;
}

/// The box that holds the bulk of the points, which must be finite and at least one.
Box3 percentileBox(std::span<const Vec3f> points) {
  Box3 box;
  std::vector<float> values(points.size());
  for (const Axis axis : kAxes) {
    std::transform(points.begin(), points.end(), values.begin(),
                   [axis](const Vec3f& point) { return point[axis]; });
    box.lower[axis] = valuePercentile(values, kLowerPercentile);
    box.upper[axis] = valuePercentile(values, kUpperPercentile);
  }
  return box;
}

/// The points in the box enlarged to every side by its largest size, not by the size along the same
/// axis: so a model that is mostly flat keeps what stands out of it.
std::vector<Vec3d> pointsNear(const Box3& box, std::span<const Vec3f> points) {
  const Vec3d lower(box.lower);
  const Vec3d upper(box.upper);
  const Vec3d size = upper - lower;
  const double reach = std::max({size.x, size.y, size.z});
  std::vector<Vec3d> near;
  near.reserve(points.size());
  for (const Vec3f& point : points) {
    const Vec3d candidate(point);
    const bool isNear = std::all_of(kAxes.begin(), kAxes.end(), [&](Axis axis) {
      return candidate[axis] >= lower[axis] - reach && candidate[axis] <= upper[axis] + reach;
    });
    if (isNear)
      near.push_back(candidate);
  }
  return near;
}

/// Adds the corners of the box around the points.
void addBoxCorners(std::vector<Vec3d>& points) {
  Box3 box;
  for (const Vec3d& point : points)
    box.extend(point);
  for (const float x : {box.lower.x, box.upper.x}) {
    for (const float y : {box.lower.y, box.upper.y}) {
      for (const float z : {box.lower.z, box.upper.z})
        points.push_back(Vec3d(Vec3f{x, y, z}));
    }
  }
}

/// The highest value of each of the four edge functions of the frame, and the depths, over all
/// points, measured from the origin along the camera's axes.
struct FrameSupport {
  double right = -std::numeric_limits<double>::infinity();
  double left = -std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();
  double bottom = -std::numeric_limits<double>::infinity();
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -std::numeric_limits<double>::infinity();
};

FrameSupport frameSupport(std::span<const Vec3d> points, const CameraAxes& axes, double slopeX,
                          double slopeY) {
  FrameSupport support;
  for (const Vec3d& point : points) {
    const double x = dot(point, axes.right);
    const double y = dot(point, axes.up);
    const double depth = dot(point, axes.forward);
    support.right = std::max(support.right, x - slopeX * depth);
    support.left = std::max(support.left, -x - slopeX * depth);
    support.top = std::max(support.top, y - slopeY * depth);
    support.bottom = std::max(support.bottom, -y - slopeY * depth);
    support.nearest = std::min(support.nearest, depth);
    support.farthest = std::max(support.farthest, depth);
  }
  return support;
}

/// The unit vector from the model to the eye: a little from the right and from above.
Vec3d viewpoint(UpAxis up) {
  return normalized(up == UpAxis::Y ? Vec3d{0.55, 0.35, 0.76} : Vec3d{0.55, -0.76, 0.35});
}

}  // namespace

Vec3f upVector(UpAxis up) noexcept {
  return up == UpAxis::Y ? Vec3f{0.0f, 1.0f, 0.0f} : Vec3f{0.0f, 0.0f, 1.0f};
}

std::optional<Camera> frameCamera(std::span<const Vec3f> points, const Framing& framing) {
  const std::vector<Vec3f> finite = finitePoints(points);
  if (finite.empty())
    return std::nullopt;
  std::vector<Vec3d> model = pointsNear(percentileBox(finite), finite);
  if (framing.showsBox)
    addBoxCorners(model);

  const CameraAxes axes = cameraAxes(-viewpoint(framing.up), Vec3d(upVector(framing.up)));
  const double halfFov = static_cast<double>(framing.fovDegrees) * std::numbers::pi / 360.0;
  const double slopeY = kFill * std::tan(halfFov);
  const double slopeX = slopeY * framing.aspect;

  // A point is inside the right edge of the frame if x - eyeX <= slopeX (depth - eyeDepth), and
  // likewise for the other edges. So the edges cut off nothing if
  //     eyeX - slopeX eyeDepth >= support.right  and  -eyeX - slopeX eyeDepth >= support.left;
  // the sum bounds eyeDepth, and halving the difference puts the model in the middle.
  const FrameSupport support = frameSupport(model, axes, slopeX, slopeY);
  double eyeDepth = std::min(-(support.right + support.left) / (2.0 * slopeX),
                             -(support.top + support.bottom) / (2.0 * slopeY));
  const double eyeX = (support.right - support.left) / 2.0;
  const double eyeY = (support.top - support.bottom) / 2.0;
  const double atDepth = (support.nearest + support.farthest) / 2.0;

  // A single point would put the eye into it. A few units in the last place of the coordinates keep
  // the eye another point after rounding to float, and no model that is larger too far away.
  const double reach = std::max({std::fabs(atDepth), std::fabs(eyeX), std::fabs(eyeY), 1e-30});
  constexpr double kApart = 16.0 * std::numeric_limits<float>::epsilon();
  eyeDepth = std::min(eyeDepth, atDepth - kApart * reach);

  const Vec3d side = axes.right * eyeX + axes.up * eyeY;
  return Camera{.eye = Vec3f(side + axes.forward * eyeDepth),
                .at = Vec3f(side + axes.forward * atDepth),
                .up = upVector(framing.up),
                .fovDegrees = framing.fovDegrees};
}

std::vector<Vec3f> visiblePoints(const TriangleMeshView<float>& mesh) {
  std::vector<bool> isSeen(mesh.vertexCount());
  std::vector<Vec3f> points;
  for (std::size_t face = 0; face < mesh.size(); ++face) {
    if (!mesh[face].isUsable())
      continue;
    for (const std::uint32_t vertex : mesh.indices(face)) {
      if (isSeen[vertex])
        continue;
      isSeen[vertex] = true;
      points.push_back(mesh.position(vertex));
    }
  }
  return points;
}

}  // namespace planetree::render
