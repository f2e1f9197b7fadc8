#include "render/framing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

namespace planetree::render {
namespace {

/// Where a point appears: 0 to 1 from left to right and from top to bottom.
std::pair<double, double> placeInPicture(const Camera& camera, double aspect, const Vec3f& point) {
  const CameraAxes axes = cameraAxes(Vec3d(camera.at) - Vec3d(camera.eye), Vec3d(camera.up));
  const Vec3d offset = Vec3d(point) - Vec3d(camera.eye);
  const double depth = dot(offset, axes.forward);
  EXPECT_GT(depth, 0.0) << "behind the camera";
  const double halfHeight =
      depth * std::tan(static_cast<double>(camera.fovDegrees) * std::numbers::pi / 360.0);
  return {0.5 + dot(offset, axes.right) / (2.0 * halfHeight * aspect),
          0.5 - dot(offset, axes.up) / (2.0 * halfHeight)};
}

std::vector<Vec3f> randomPoints(const Vec3d& size, const Vec3d& center, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> inside(-0.5, 0.5);
  std::vector<Vec3f> points;
  for (int i = 0; i < 5000; ++i) {
    const double x = inside(random);
    const double y = inside(random);
    const double z = inside(random);
    points.push_back(Vec3f(center + Vec3d{x * size.x, y * size.y, z * size.z}));
  }
  return points;
}

/// Every point is in the picture with a margin, and some point is near an edge.
void expectTightFrame(const std::vector<Vec3f>& points, const Framing& framing) {
  const auto camera = frameCamera(points, framing);
  ASSERT_TRUE(camera);
  double nearestToEdge = 1.0;
  for (const Vec3f& point : points) {
    const auto [x, y] = placeInPicture(*camera, framing.aspect, point);
    nearestToEdge = std::min({nearestToEdge, x, 1.0 - x, y, 1.0 - y});
  }
  EXPECT_GT(nearestToEdge, 0.02);
  EXPECT_LT(nearestToEdge, 0.06);
}

TEST(FrameCamera, ShowsTheWholeModelInPicturesOfAnyShape) {
  for (const double aspect : {0.1, 0.75, 1.0, 4.0 / 3.0, 16.0 / 9.0, 20.0}) {
    for (const float fov : {5.0f, 40.0f, 120.0f}) {
      for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
        SCOPED_TRACE(testing::Message() << "aspect " << aspect << ", fov " << fov);
        expectTightFrame(randomPoints({3.0, 1.0, 2.0}, {1.0, 2.0, -5.0}, 1),
                         {.up = up, .fovDegrees = fov, .aspect = aspect});
      }
    }
  }
}

TEST(FrameCamera, ShowsFlatThinTinyAndHugeModels) {
  for (const Vec3d& size : {Vec3d{1.0, 0.0, 1.0}, Vec3d{0.0, 0.0, 1.0}, Vec3d{1e-3, 1.0, 1e-3},
                            Vec3d{1e-9, 2e-9, 1e-9}, Vec3d{1e8, 2e8, 1e8}}) {
    SCOPED_TRACE(testing::Message() << size.x << " x " << size.y << " x " << size.z);
    expectTightFrame(randomPoints(size, {}, 2), {});
  }
}

TEST(FrameCamera, ShowsModelsFarFromTheOrigin) {
  expectTightFrame(randomPoints({10.0, 10.0, 10.0}, {1e5, -1e5, 2e5}, 7), {});
}

TEST(FrameCamera, StraysDoNotMoveTheCamera) {
  std::vector<Vec3f> points = randomPoints({1.0, 1.0, 1.0}, {}, 3);
  const auto clean = frameCamera(points, {});
  for (const float far : {1e3f, 1e6f, 1e30f, -1e30f})
    points.push_back({far, 0.0f, far});
  const auto withStrays = frameCamera(points, {});
  ASSERT_TRUE(clean && withStrays);
  EXPECT_EQ(clean->eye, withStrays->eye);
  EXPECT_EQ(clean->at, withStrays->at);
}

TEST(FrameCamera, PointsThatAreNotFiniteDoNotCount) {
  std::vector<Vec3f> points = randomPoints({1.0, 1.0, 1.0}, {}, 4);
  const auto clean = frameCamera(points, {});
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  points.insert(points.end(), 1000, Vec3f{kNan, 0.0f, 0.0f});
  points.insert(points.end(), 1000, Vec3f{0.0f, kInfinity, 0.0f});
  const auto withOthers = frameCamera(points, {});
  ASSERT_TRUE(clean && withOthers);
  EXPECT_EQ(clean->eye, withOthers->eye);
  EXPECT_FALSE(frameCamera(std::vector<Vec3f>{{kNan, kNan, kNan}}, {}));
  EXPECT_FALSE(frameCamera({}, {}));
}

TEST(FrameCamera, KeepsSmallPartsThatStandOutOfTheBulk) {
  // An antenna: one point in ten thousand, one size of the body above it.
  std::vector<Vec3f> points = randomPoints({1.0, 1.0, 1.0}, {}, 5);
  points.push_back({0.0f, 1.4f, 0.0f});
  expectTightFrame(points, {});
}

TEST(FrameCamera, LooksAtASinglePointFromAnotherOne) {
  for (const Vec3f& point : {Vec3f{0.0f, 0.0f, 0.0f}, Vec3f{1.0f, 2.0f, 3.0f},
                             Vec3f{-1e6f, 1e6f, 1e6f}, Vec3f{1e-20f, 0.0f, 0.0f}}) {
    const auto camera = frameCamera(std::vector<Vec3f>(3, point), {});
    ASSERT_TRUE(camera);
    EXPECT_NE(camera->eye, camera->at);
    EXPECT_TRUE(isFinite(camera->eye));
  }
}

TEST(FrameCamera, PutsTheGivenAxisUp) {
  const std::vector<Vec3f> points = randomPoints({1.0, 1.0, 1.0}, {}, 6);
  const auto yUp = frameCamera(points, {.up = UpAxis::Y});
  const auto zUp = frameCamera(points, {.up = UpAxis::Z});
  EXPECT_EQ(yUp->up, (Vec3f{0.0f, 1.0f, 0.0f}));
  EXPECT_GT(yUp->eye.y, yUp->at.y);
  EXPECT_EQ(zUp->up, (Vec3f{0.0f, 0.0f, 1.0f}));
  EXPECT_GT(zUp->eye.z, zUp->at.z);
}

TEST(VisiblePoints, AreThoseOfUsableFacesEachOnce) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  TriangleMesh<float> mesh;
  mesh.positions = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f},
                    {9.0f, 9.0f, 9.0f}, {kNan, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
  mesh.faces = {{0, 1, 2}, {0, 1, 4}, {0, 1, 77}, {0, 2, 5}};
  const std::vector<Vec3f> expected = {mesh.positions[0], mesh.positions[1], mesh.positions[2],
                                       mesh.positions[5]};
  EXPECT_EQ(visiblePoints(mesh.view()), expected);
}

TEST(FrameCamera, ShowsTheCornersOfTheBoxIfAskedTo) {
  // Points along the diagonal of a box: its other corners are where nothing else is.
  std::vector<Vec3f> points;
  for (int i = 0; i <= 100; ++i) {
    const auto place = static_cast<float>(i) / 100.0f;
    points.push_back({place, place, place});
  }
  Framing framing;
  framing.showsBox = true;
  const auto camera = frameCamera(points, framing);
  ASSERT_TRUE(camera);
  const PinholeCamera pinhole(*camera, framing.aspect);
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3d view = pinhole.viewCoordinates(
        {corner & 1u ? 1.0 : 0.0, corner & 2u ? 1.0 : 0.0, corner & 4u ? 1.0 : 0.0});
    EXPECT_GT(view.z, 0.0);
    EXPECT_LT(std::fabs(view.x), view.z);
    EXPECT_LT(std::fabs(view.y), view.z);
  }
}

}  // namespace
}  // namespace planetree::render
