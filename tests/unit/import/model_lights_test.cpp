#include "import/model_lights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace planetree::test {
namespace {

using namespace importing;
using scene::PointLight;
using scene::SceneDescription;

/// A box of size `size` around the origin.
SceneDescription boxOf(double size) {
  SceneDescription scene;
  scene.shapes.push_back({.shape = scene::UnitBox{},
                          .placement = scene::Affine::scaling({size, size, size}),
                          .material = 0,
                          .name = {}});
  return scene;
}

ModelLight lightOf(LightKind kind, const Vec3d& colour) {
  return {.kind = kind,
          .position = {0, 10, 0},
          .direction = {0, -2, 0},
          .colour = colour,
          .attenuation = {1, 0, 0}};
}

bool hasRemark(const SceneDescription& scene, const std::string& words) {
  return std::any_of(scene.remarks.begin(), scene.remarks.end(), [&](const std::string& remark) {
    return remark.find(words) != std::string::npos;
  });
}

Vec3d lightAtDistance(const PointLight& light, double d) {
  const double fall = light.constant + d * (light.linear + d * light.quadratic);
  return light.colour * std::min(1.0, 1.0 / fall);
}

TEST(AddLights, PassesLightsOnAndAddsALittleAmbientLight) {
  SceneDescription scene = boxOf(1);
  ModelLight lamp = lightOf(LightKind::Point, {0.5, 0.25, 0.125});
  lamp.attenuation = {1, 0.5, 0.25};
  addLights(std::vector{lamp, lightOf(LightKind::Directional, {0, 0.75, 0})}, scene);
  ASSERT_EQ(scene.pointLights.size(), 1u);
  EXPECT_EQ(scene.pointLights[0].position, (Vec3d{0, 10, 0}));
  EXPECT_EQ(scene.pointLights[0].colour, (Vec3d{0.5, 0.25, 0.125}));
  EXPECT_EQ(scene.pointLights[0].constant, 1.0);
  EXPECT_EQ(scene.pointLights[0].linear, 0.5);
  EXPECT_EQ(scene.pointLights[0].quadratic, 0.25);
  ASSERT_EQ(scene.directionalLights.size(), 1u);
  EXPECT_EQ(scene.directionalLights[0].direction, (Vec3d{0, -2, 0}));
  EXPECT_EQ(scene.directionalLights[0].colour, (Vec3d{0, 0.75, 0}));
  EXPECT_EQ(scene.ambientLight, (Vec3d{0.1, 0.1, 0.1}));
  EXPECT_TRUE(scene.remarks.empty());
}

TEST(AddLights, AddsUpTheAmbientLightOfTheFile) {
  SceneDescription scene = boxOf(1);
  addLights(std::vector{lightOf(LightKind::Ambient, {0.25, 0, 0}),
                        lightOf(LightKind::Ambient, {0.25, 0.5, 0}),
                        lightOf(LightKind::Directional, {1, 1, 1})},
            scene);
  EXPECT_EQ(scene.ambientLight, (Vec3d{0.5, 0.5, 0}));
}

TEST(AddLights, AddsNothingToAFileWithoutLights) {
  SceneDescription scene = boxOf(1);
  addLights({}, scene);
  EXPECT_EQ(scene.ambientLight, (Vec3d{}));
}

TEST(AddLights, MakesPointLightsOfSpotAndAreaLights) {
  SceneDescription scene = boxOf(1);
  addLights(std::vector{lightOf(LightKind::Spot, {1, 1, 1}), lightOf(LightKind::Spot, {1, 1, 1}),
                        lightOf(LightKind::Area, {1, 1, 1})},
            scene);
  EXPECT_EQ(scene.pointLights.size(), 3u);
  EXPECT_EQ(scene.remarks.size(), 2u);
  EXPECT_TRUE(hasRemark(scene, "spot lights"));
  EXPECT_TRUE(hasRemark(scene, "area lights"));
}

TEST(AddLights, DimsLightsThatWouldBeTooBrightTogether) {
  SceneDescription scene = boxOf(1);
  addLights(
      std::vector{lightOf(LightKind::Point, {4, 2, 0}), lightOf(LightKind::Directional, {1, 1, 1})},
      scene);
  EXPECT_EQ(scene.pointLights[0].colour, (Vec3d{1, 0.5, 0}));
  EXPECT_EQ(scene.directionalLights[0].colour, (Vec3d{0.25, 0.25, 0.25}));
  EXPECT_TRUE(hasRemark(scene, "too bright"));
  // Bright for being far away is not too bright.
  SceneDescription far = boxOf(1);
  ModelLight lamp = lightOf(LightKind::Point, {50, 50, 50});
  lamp.attenuation = {0, 0, 1};
  addLights(std::vector{lamp}, far);
  EXPECT_EQ(far.pointLights[0].colour, (Vec3d{50, 50, 50}));
}

TEST(AddLights, ExposesMeasuredLightsBothWays) {
  for (const double lux : {1e-3, 0.5, 1e5}) {
    SceneDescription scene = boxOf(1);
    addLights(std::vector{lightOf(LightKind::PhotometricDirectional, {lux, lux / 2, 0})}, scene);
    EXPECT_NEAR(scene.directionalLights[0].colour.x, 1, 1e-15);
    EXPECT_NEAR(scene.directionalLights[0].colour.y, 0.5, 1e-15);
    EXPECT_TRUE(scene.remarks.empty());
  }
}

TEST(AddLights, LetsMeasuredPointLightsFallOffWithTheSquareInAnyUnit) {
  for (const double size : {1e-4, 1.0, 1e4}) {
    SceneDescription scene = boxOf(size);
    ModelLight lamp = lightOf(LightKind::PhotometricPoint, {7, 7, 7});
    lamp.position = {0, 3 * size, 0};
    addLights(std::vector{lamp}, scene);
    // White in the middle, and by the square elsewhere.
    for (const double d : {0.1, 1.0, 3.0, 6.0}) {
      const double expected = 9.0 / (d * d);
      EXPECT_NEAR(lightAtDistance(scene.pointLights[0], d * size).x, expected, 1e-6 * expected)
          << size << ' ' << d;
    }
  }
}

TEST(AddLights, TakesLightsInTheMiddleToBeMeantForTheWalls) {
  SceneDescription scene = boxOf(2);
  ModelLight lamp = lightOf(LightKind::PhotometricPoint, {1, 1, 1});
  lamp.position = {0, 0, 0};
  addLights(std::vector{lamp}, scene);
  const double quarter = std::sqrt(12.0) / 4;
  EXPECT_NEAR(lightAtDistance(scene.pointLights[0], quarter).x, 1, 1e-6);
}

TEST(AddLights, LightsScenesWithoutShapes) {
  SceneDescription scene;
  addLights(std::vector{lightOf(LightKind::PhotometricPoint, {1, 1, 1})}, scene);
  EXPECT_NEAR(lightAtDistance(scene.pointLights[0], 10).x, 1, 1e-12);
}

TEST(ViewOf, SetsTheAxesOfThePicture) {
  const ModelCamera camera = {.position = {1, 2, 3},
                              .direction = {0, 0, 5},
                              .up = {0, 3, 4},  // not at a right angle
                              .angleAcross = std::numbers::pi / 2,
                              .aspect = 2};
  const auto view = viewOf(camera);
  ASSERT_TRUE(view.has_value());
  EXPECT_EQ(view->eye, (Vec3d{1, 2, 3}));
  EXPECT_EQ(view->look, (Vec3d{0, 0, 1}));
  // Looking along z with y up, right is -x.
  EXPECT_NEAR(view->u.x, -2, 1e-15);
  EXPECT_NEAR(view->v.y, 1, 1e-15);
  EXPECT_EQ(view->v.z, 0.0);
}

TEST(ViewOf, MakesASquarePictureWhereTheFileDoesNotSay) {
  const auto view =
      viewOf({.position = {}, .direction = {0, 0, -1}, .up = {0, 1, 0}, .angleAcross = 1});
  ASSERT_TRUE(view.has_value());
  EXPECT_EQ(view->aspectRatio(), 1.0);
}

TEST(ViewOf, RefusesDirectionsThatSayNothing) {
  const auto isView = [](const Vec3d& direction, const Vec3d& up) {
    return viewOf({.position = {}, .direction = direction, .up = up, .angleAcross = 1}).has_value();
  };
  EXPECT_TRUE(isView({0, 0, -1e-300}, {0, 1e300, 0}));
  EXPECT_FALSE(isView({0, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(isView({0, 0, -1}, {0, 0, 0}));
  EXPECT_FALSE(isView({0, 1, 0}, {0, -2, 0}));
  EXPECT_FALSE(isView({0, NAN, -1}, {0, 1, 0}));
}

}  // namespace
}  // namespace planetree::test
