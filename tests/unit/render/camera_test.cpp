#include "render/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace planetree::render {
namespace {

constexpr double kFloatRounding = 1e-6;

void expectNear(const Vec3f& actual, const Vec3d& expected) {
  EXPECT_NEAR(static_cast<double>(actual.x), expected.x, kFloatRounding);
  EXPECT_NEAR(static_cast<double>(actual.y), expected.y, kFloatRounding);
  EXPECT_NEAR(static_cast<double>(actual.z), expected.z, kFloatRounding);
}

TEST(PinholeCamera, LooksAtItsPointInTheMiddleOfThePicture) {
  const Camera camera{.eye = {1.0f, 2.0f, 3.0f}, .at = {4.0f, 6.0f, 3.0f}};
  const Rayf ray = PinholeCamera(camera, 1.5).ray(0.5, 0.5);
  EXPECT_EQ(ray.origin, camera.eye);
  expectNear(ray.direction, {0.6, 0.8, 0.0});
}

TEST(PinholeCamera, SpansTheFieldOfViewFromLowerToUpperEdge) {
  const Camera camera{.eye = {0.0f, 0.0f, 1.0f}, .fovDegrees = 90.0f};
  const PinholeCamera pinhole(camera, 2.0);
  const double diagonal = std::sqrt(0.5);
  expectNear(pinhole.ray(0.5, 0.0).direction, {0.0, diagonal, -diagonal});
  expectNear(pinhole.ray(0.5, 1.0).direction, {0.0, -diagonal, -diagonal});
  const double wide = std::sqrt(5.0);
  expectNear(pinhole.ray(1.0, 0.5).direction, {2.0 / wide, 0.0, -1.0 / wide});
  expectNear(pinhole.ray(0.0, 0.5).direction, {-2.0 / wide, 0.0, -1.0 / wide});
}

TEST(PinholeCamera, RaysHaveUnitDirectionsAndNoEnd) {
  const PinholeCamera pinhole({.eye = {5.0f, -3.0f, 1.0f}, .fovDegrees = 120.0f}, 1.7);
  for (const double x : {0.0, 0.3, 1.0}) {
    for (const double y : {0.0, 0.8, 1.0}) {
      const Rayf ray = pinhole.ray(x, y);
      EXPECT_NEAR(static_cast<double>(length(ray.direction)), 1.0, kFloatRounding);
      EXPECT_EQ(ray.tMin, 0.0f);
      EXPECT_EQ(ray.tMax, std::numeric_limits<float>::infinity());
    }
  }
}

TEST(PinholeCamera, ViewCoordinatesUndoItsRays) {
  const PinholeCamera pinhole({.eye = {5.0f, -3.0f, 1.0f}, .fovDegrees = 70.0f}, 1.7);
  for (const double x : {0.0, 0.3, 1.0}) {
    for (const double y : {0.0, 0.5, 0.8}) {
      const Rayf ray = pinhole.ray(x, y);
      const Vec3d view = pinhole.viewCoordinates(Vec3d(ray.at(12.0f)));
      EXPECT_NEAR(0.5 + 0.5 * view.x / view.z, x, kFloatRounding);
      EXPECT_NEAR(0.5 - 0.5 * view.y / view.z, y, kFloatRounding);
      EXPECT_NEAR(view.z, 12.0 * dot(Vec3d(ray.direction), pinhole.axes().forward), 1e-5);
    }
  }
}

TEST(CameraAxes, AreUnitVectorsAtRightAnglesEvenAlongUp) {
  for (const Vec3d& forward :
       {Vec3d{1.0, 2.0, 3.0}, Vec3d{0.0, -1.0, 0.0}, Vec3d{0.0, 7.0, 0.0}, Vec3d{1e-9, 1.0, 0.0},
        Vec3d{1e-30, 2e-30, 0.0}, Vec3d{1e30, 0.0, 1e30}}) {
    const CameraAxes axes = cameraAxes(forward, {0.0, 1.0, 0.0});
    for (const Vec3d& axis : {axes.right, axes.up, axes.forward}) {
      EXPECT_NEAR(length(axis), 1.0, 1e-12);
    }
    EXPECT_NEAR(dot(axes.right, axes.up), 0.0, 1e-12);
    EXPECT_NEAR(dot(axes.right, axes.forward), 0.0, 1e-12);
    EXPECT_NEAR(dot(axes.forward, normalized(forward)), 1.0, 1e-12);
    EXPECT_NEAR(dot(cross(axes.right, axes.up), axes.forward), -1.0, 1e-12) << "mirrored";
  }
}

}  // namespace
}  // namespace planetree::render
