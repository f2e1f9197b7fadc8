#include "unit/scene/ray_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace planetree::test {
namespace {

TEST(RayLights, OfAmbientKindAddUp) {
  EXPECT_EQ(readStatements("").ambientLight, (Vec3d{0, 0, 0}));
  const auto scene = readStatements(
      "ambient_light { color = (.25, .5, 0); } ambient_light { colour = (.25, 0, 1) }");
  EXPECT_EQ(scene.ambientLight, (Vec3d{0.5, 0.5, 1}));
}

TEST(RayLights, OfDirectionalKindTravelThatWay) {
  const auto scene =
      readStatements("directional_light { direction = (0, 0, 3); color = (1, .5, 0); }");
  ASSERT_EQ(scene.directionalLights.size(), 1u);
  EXPECT_EQ(scene.directionalLights[0].direction, (Vec3d{0, 0, 3}));
  EXPECT_EQ(scene.directionalLights[0].colour, (Vec3d{1, 0.5, 0}));
}

TEST(RayLights, OfPointKindFadeWithTheSquareByDefault) {
  const auto scene = readStatements("point_light { colour = (1, .5, 0); position = (0, 5, 0); }");
  ASSERT_EQ(scene.pointLights.size(), 1u);
  EXPECT_EQ(scene.pointLights[0].position, (Vec3d{0, 5, 0}));
  EXPECT_EQ(scene.pointLights[0].colour, (Vec3d{1, 0.5, 0}));
  EXPECT_EQ(scene.pointLights[0].constant, 0.0);
  EXPECT_EQ(scene.pointLights[0].linear, 0.0);
  EXPECT_EQ(scene.pointLights[0].quadratic, 1.0);
}

TEST(RayLights, OfPointKindFadeAsTheyAreTold) {
  const auto scene = readStatements(
      "point_light { position = (0, 5, 0); color = (1, 1, 1); constant_attenuation_coeff = 0.25;"
      "linear_attenuation_coeff = 0.5; quadratic_attenuation_coeff = 0; }"
      "point_light { position = (1, 5, 0); color = (1, 1, 1) }");
  ASSERT_EQ(scene.pointLights.size(), 2u);
  EXPECT_EQ(scene.pointLights[0].constant, 0.25);
  EXPECT_EQ(scene.pointLights[0].linear, 0.5);
  EXPECT_EQ(scene.pointLights[0].quadratic, 0.0);
  EXPECT_EQ(scene.pointLights[1].quadratic, 1.0);
}

TEST(RayLights, NeedWhatHasNoDefault) {
  EXPECT_EQ(errorOf("ambient_light {}"),
            "test.ray:2:1: the \"ambient_light\" has no \"color\". Add color = (..., ..., ...)");
  EXPECT_EQ(
      errorOf("sphere {} directional_light { color = (1, 1, 1) }"),
      "test.ray:2:11: the \"directional_light\" has no \"direction\". Add direction = (..., ..., "
      "...)");
  EXPECT_EQ(
      errorOf("directional_light { direction = (0, 0, 1) }"),
      "test.ray:2:1: the \"directional_light\" has no \"color\". Add color = (..., ..., ...)");
  EXPECT_EQ(
      errorOf("point_light { color = (1, 1, 1) }"),
      "test.ray:2:1: the \"point_light\" has no \"position\". Add position = (..., ..., ...)");
  EXPECT_EQ(errorOf("point_light { position = (1, 1, 1) }"),
            "test.ray:2:1: the \"point_light\" has no \"color\". Add color = (..., ..., ...)");
}

TEST(RayLights, AreToldEverythingOnce) {
  EXPECT_EQ(errorOf("ambient_light { color = (1, 1, 1);\n colour = (1, 1, 1); }"),
            "test.ray:3:2: \"color\" of \"ambient_light\" is given a second time, after line 2, "
            "column 17. Leave out one of them");
  EXPECT_EQ(errorOf("directional_light { direction = (1, 1, 1); direction = (1, 1, 1); }"),
            "test.ray:2:44: \"direction\" of \"directional_light\" is given a second time, after "
            "line 2, column 21. Leave out one of them");
  EXPECT_EQ(errorOf("point_light { position = (1, 1, 1); position = (1, 1, 1); }"),
            "test.ray:2:37: \"position\" of \"point_light\" is given a second time, after line 2, "
            "column 15. Leave out one of them");
  EXPECT_NE(errorOf("point_light { position = (1, 1, 1) color = (1, 1, 1) "
                    "linear_attenuation_coeff = 1 linear_attenuation_coeff = 1 }"),
            "no error");
}

TEST(RayLights, HaveADirection) {
  EXPECT_EQ(errorOf("directional_light { direction = (0, 0, -0); color = (1, 1, 1) }"),
            "test.ray:2:21: the \"direction\" is (0, 0, 0). Say in which direction the light "
            "travels");
}

TEST(RayLights, HaveNoValuesWithoutMeaning) {
  const std::string colour =
      ": expected a part of a colour of 0 or more, found \"-1\". It cannot be negative";
  EXPECT_EQ(errorOf("ambient_light { color = (-1, 0, 0) }"), "test.ray:2:26" + colour);
  EXPECT_EQ(errorOf("directional_light { colour = (1, 1, -1) }"), "test.ray:2:37" + colour);
  EXPECT_EQ(errorOf("point_light { colour = (1, -1, 1) }"), "test.ray:2:28" + colour);
  for (const std::string keyword : {"constant", "linear", "quadratic"}) {
    EXPECT_EQ(errorOf("point_light {\n" + keyword + "_attenuation_coeff\n= -0.25 }"),
              "test.ray:4:3: expected a coefficient of attenuation of 0 or more, found "
              "\"-0.25\". It cannot be negative");
  }
  EXPECT_EQ(errorOf("directional_light { direction = (-1, -1, -1); color = (0, 0, 3) }"),
            "no error");
}

TEST(RayLights, StandOutsideOfGroups) {
  EXPECT_EQ(errorOf("{ point_light { } }"),
            "test.ray:2:3: expected a shape, transform, material, group or '}', found "
            "\"point_light\". Cameras and lights stand outside of all groups and transforms");
  EXPECT_EQ(errorOf("scale(2, camera { })"),
            "test.ray:2:10: expected a shape, transform or group to be transformed, found "
            "\"camera\". Cameras and lights stand outside of all groups and transforms");
}

TEST(RayLights, TellWhatTheyExpect) {
  EXPECT_EQ(errorOf("point_light { colr = (1, 1, 1) }"),
            "test.ray:2:15: expected '}' or a keyword of \"point_light\", found \"colr\". Did you "
            "mean \"color\"?");
  EXPECT_EQ(errorOf("ambient_light = { }"),
            "test.ray:2:15: expected '{' behind \"ambient_light\", found '='. Write ambient_light "
            "{ ... }");
}

}  // namespace
}  // namespace planetree::test
