#include "bench/scene/cameras.hpp"

#include "bench_meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace planetree::bench {
namespace {

/// How far a point is from the middle of the picture: 1 at its edges.
double placeInPicture(const render::Camera& camera, const Vec3f& point) {
  const Vec3d forward = normalized(Vec3d(camera.at) - Vec3d(camera.eye));
  const render::CameraAxes axes = render::cameraAxes(forward, Vec3d(camera.up));
  const Vec3d offset = Vec3d(point) - Vec3d(camera.eye);
  const double slope = std::tan(static_cast<double>(camera.fovDegrees) * std::numbers::pi / 360.0);
  const double side =
      std::fmax(std::fabs(dot(offset, axes.right)), std::fabs(dot(offset, axes.up)));
  return side / (dot(offset, axes.forward) * slope);
}

std::vector<Vec3f> corners(float x, float y, float z) {
  std::vector<Vec3f> points;
  for (const float a : {-x, x}) {
    for (const float b : {-y, y}) {
      for (const float c : {-z, z})
        points.push_back({a, b, c});
    }
  }
  return points;
}

TEST(SceneCamera, IsInsideTheKnownInteriors) {
  const render::Camera sponza = sceneCamera("sponza", {});
  EXPECT_EQ(sponza.eye, (Vec3f{-6.8f, 1.6f, -0.25f}));
  EXPECT_EQ(sponza.at, (Vec3f{5.0f, 2.6f, 0.0f}));
  EXPECT_EQ(sponza.fovDegrees, 70.0f);
  EXPECT_EQ(sceneCamera("conference_clean", {}).fovDegrees, 60.0f);
  EXPECT_EQ(sceneCamera("kitchen", {}).eye, (Vec3f{1.2f, 1.7f, 3.8f}));
  EXPECT_EQ(sceneCamera("sibenik", {}).at, (Vec3f{10.0f, -7.0f, -1.0f}));
}

TEST(SceneCamera, FramesEverythingElse) {
  const auto positions = test::ball().positions;
  EXPECT_EQ(sceneCamera("ball", positions).eye, framingCamera(positions).eye);
}

TEST(FramingCamera, LooksFromTheDocumentedSideWithFortyDegrees) {
  const render::Camera camera = framingCamera(test::ball().positions);
  const Vec3d toward = normalized(Vec3d(camera.eye) - Vec3d(camera.at));
  const Vec3d documented = normalized(Vec3d{0.55, 0.35, 0.76});
  EXPECT_NEAR(length(toward - documented), 0.0, 1e-6);
  EXPECT_EQ(camera.fovDegrees, 40.0f);
}

TEST(FramingCamera, FitsTheBoxTightly) {
  for (const auto& points : {corners(1, 1, 1), corners(5, 0.1f, 1), corners(0.1f, 9, 0)}) {
    const render::Camera camera = framingCamera(points);
    double farthest = 0.0;
    for (const Vec3f& point : points)
      farthest = std::fmax(farthest, placeInPicture(camera, point));
    EXPECT_NEAR(farthest, 1.0, 1e-5);
  }
}

TEST(FramingCamera, IgnoresTheOuterTwoPercentAndWhatIsNotFinite) {
  std::vector<Vec3f> points;
  for (int i = 0; i < 1000; ++i)
    points.push_back(
        {static_cast<float>(i % 10), static_cast<float>(i / 10 % 10), static_cast<float>(i / 100)});
  const render::Camera before = framingCamera(points);
  for (int i = 0; i < 10; ++i)
    points.push_back({1e6f, -1e6f, 1e6f});
  points.push_back({std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f});
  points.push_back({std::numeric_limits<float>::infinity(), 0.0f, 0.0f});
  EXPECT_EQ(framingCamera(points).eye, before.eye);
}

TEST(FramingCamera, LooksAtASinglePointFromOutside) {
  const render::Camera camera = framingCamera(std::vector<Vec3f>{{3.0f, 4.0f, 5.0f}});
  EXPECT_EQ(camera.at, (Vec3f{3.0f, 4.0f, 5.0f}));
  EXPECT_NE(camera.eye, camera.at);
}

}  // namespace
}  // namespace planetree::bench
