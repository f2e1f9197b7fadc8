#include "scene/default_lighting.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planetree::test {
namespace {

using namespace scene;

SceneDescription boxAt(const Vec3d& middle, double size) {
  SceneDescription scene;
  scene.shapes.push_back(
      {.shape = UnitBox{},
       .placement = Affine::translation(middle) * Affine::scaling({size, size, size}),
       .material = 0,
       .name = {}});
  return scene;
}

TEST(AddDefaultLighting, PutsTheKeyLightToTheUpperLeftOfTheViewerAndTheFillLightToTheRight) {
  const Vec3d middle{100, 200, 300};
  SceneDescription scene = boxAt(middle, 10);
  scene.view = View{.eye = middle + Vec3d{50, 0, 0}, .look = {-1, 0, 0}, .u = {0, 0, -1}};
  ASSERT_TRUE(addDefaultLighting(scene));
  ASSERT_EQ(scene.pointLights.size(), 2u);
  const Vec3d key = scene.pointLights[0].position - middle;
  const Vec3d fill = scene.pointLights[1].position - middle;
  EXPECT_GT(key.x, 0);  // on the side of the viewer,
  EXPECT_GT(key.y, 0);  // above,
  EXPECT_GT(key.z, 0);  // left, for right is -z
  EXPECT_GT(fill.x, 0);
  EXPECT_LT(fill.z, 0);
  EXPECT_GT(scene.pointLights[0].colour.x, scene.pointLights[1].colour.x);
  // Outside the box, and as strong everywhere.
  for (const PointLight& light : scene.pointLights) {
    EXPECT_GT(length(light.position - middle), 10 * 1.7320508);
    EXPECT_EQ(light.constant, 1.0);
    EXPECT_EQ(light.linear, 0.0);
    EXPECT_EQ(light.quadratic, 0.0);
  }
}

TEST(AddDefaultLighting, MakesWhiteWhiteAtMost) {
  SceneDescription scene = boxAt({0, 0, 0}, 1);
  ASSERT_TRUE(addDefaultLighting(scene));
  EXPECT_GT(scene.ambientLight.x, 0);
  double sum = scene.ambientLight.x;
  for (const PointLight& light : scene.pointLights)
    sum += light.colour.x;
  EXPECT_NEAR(sum, 1, 1e-15);
}

TEST(AddDefaultLighting, ScalesAndMovesWithTheScene) {
  SceneDescription small = boxAt({0, 0, 0}, 1);
  SceneDescription large = boxAt({0, 0, 0}, 1024);
  ASSERT_TRUE(addDefaultLighting(small));
  ASSERT_TRUE(addDefaultLighting(large));
  EXPECT_EQ(large.pointLights[0].position, small.pointLights[0].position * 1024.0);
}

TEST(AddDefaultLighting, StaysInsideWhereTheViewerIs) {
  SceneDescription room = boxAt({0, 0, 0}, 10);
  room.view = View{.eye = {0, 0, 4}};
  ASSERT_TRUE(addDefaultLighting(room));
  for (const PointLight& light : room.pointLights) {
    for (const Axis axis : kAxes)
      EXPECT_LT(std::abs(light.position[axis]), 5.0);
  }
}

TEST(AddDefaultLighting, LeavesScenesWithLightsAlone) {
  SceneDescription lamp = boxAt({0, 0, 0}, 1);
  lamp.pointLights.push_back({.position = {1, 2, 3}, .colour = {1, 1, 1}});
  EXPECT_FALSE(addDefaultLighting(lamp));
  EXPECT_EQ(lamp.pointLights.size(), 1u);
  EXPECT_EQ(lamp.ambientLight, (Vec3d{}));
  SceneDescription sun = boxAt({0, 0, 0}, 1);
  sun.directionalLights.push_back({.direction = {0, -1, 0}, .colour = {1, 1, 1}});
  EXPECT_FALSE(addDefaultLighting(sun));
  SceneDescription fog = boxAt({0, 0, 0}, 1);
  fog.ambientLight = {0, 0.5, 0};
  EXPECT_FALSE(addDefaultLighting(fog));
  EXPECT_TRUE(fog.pointLights.empty());
}

TEST(AddDefaultLighting, LightsScenesWithoutShapes) {
  SceneDescription nothing;
  ASSERT_TRUE(addDefaultLighting(nothing));
  for (const PointLight& light : nothing.pointLights)
    EXPECT_TRUE(isFinite(light.position));
}

}  // namespace
}  // namespace planetree::test
