#include "unit/scene/ray_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace planetree::test {
namespace {

using scene::View;

View viewOf(const std::string& statements) {
  const auto scene = readStatements(statements);
  EXPECT_EQ(scene.remarks, std::vector<std::string>());
  EXPECT_TRUE(scene.view.has_value());
  return scene.view.value_or(View{});
}

void expectNear(const Vec3d& a, const Vec3d& b) {
  constexpr double kTolerance = 1e-12;
  EXPECT_NEAR(a.x, b.x, kTolerance);
  EXPECT_NEAR(a.y, b.y, kTolerance);
  EXPECT_NEAR(a.z, b.z, kTolerance);
}

TEST(RayCamera, LooksAlongMinusZByDefault) {
  for (const std::string statements : {"", "camera {}", "camera { position = (0, 0, 0) }"}) {
    const View view = viewOf(statements);
    expectNear(view.eye, {0, 0, 0});
    expectNear(view.look, {0, 0, -1});
    expectNear(view.u, {1, 0, 0});
    expectNear(view.v, {0, 1, 0});
  }
}

TEST(RayCamera, HasAPositionAnAngleAndARatio) {
  const View view = viewOf("camera { position = (1, 2, 3); fov = 90; aspectratio = 1.5; }");
  expectNear(view.eye, {1, 2, 3});
  expectNear(view.look, {0, 0, -1});
  expectNear(view.u, {3, 0, 0});
  expectNear(view.v, {0, 2, 0});
  // The upper edge is 45 degrees above the middle.
  expectNear(view.direction(0.5, 1), {0, std::sqrt(0.5), -std::sqrt(0.5)});
}

TEST(RayCamera, LooksAlongItsDirections) {
  const View view = viewOf("camera { viewdir = (0, 0, 1); updir = (0, 1, 0); }");
  expectNear(view.look, {0, 0, 1});
  expectNear(view.u, {-1, 0, 0});  // right is at the left hand of who looks the other way
  expectNear(view.v, {0, 1, 0});
}

TEST(RayCamera, TurnsByAQuaternion) {
  // A quarter around y turns -z to -x.
  const View view =
      viewOf("camera { quaternian = (0, 0.7071067811865476, 0, 0.7071067811865476); fov = 90 }");
  expectNear(view.look, {-1, 0, 0});
  expectNear(view.u, {0, 0, -2});
  expectNear(view.v, {0, 2, 0});
}

TEST(RayCamera, UsesDirectionsAsTheyAre) {
  const auto scene = readStatements("camera { viewdir = (0, 0, -1); updir = (0, 2, 0); }");
  expectNear(scene.view->u, {2, 0, 0});
  expectNear(scene.view->v, {0, 2, 0});
  EXPECT_EQ(scene.remarks,
            std::vector<std::string>({"test.ray:2:32: \"updir\" does not have unit length; it is "
                                      "used as it is, which scales the picture"}));
}

TEST(RayCamera, RemarksOnDirectionsThatAreNotPerpendicular) {
  const auto scene = readStatements(
      "camera { viewdir = (0, 0.6, -0.8)\n updir = (0, 1, 0) position = (1, 0, 0) }");
  EXPECT_EQ(scene.remarks,
            std::vector<std::string>({"test.ray:2:10: \"viewdir\" and \"updir\" are not "
                                      "perpendicular, which slants the picture"}));
  // Rounded to three digits they are meant to be.
  EXPECT_TRUE(readStatements("camera { viewdir = (0, .707, -.707) updir = (0, .707, .707) }")
                  .remarks.empty());
}

TEST(RayCamera, MakesQuaternionsUnit) {
  const auto scene = readStatements("camera { quaternian = (0, 0, 0, 2) }");
  expectNear(scene.view->u, {1, 0, 0});
  EXPECT_EQ(scene.remarks, std::vector<std::string>({"test.ray:2:10: \"quaternian\" does not have "
                                                     "unit length; it is made to"}));
}

TEST(RayCamera, NeedsBothDirections) {
  EXPECT_EQ(errorOf("camera { viewdir = (0, 0, 1); }"),
            "test.ray:2:10: \"viewdir\" is given, but not \"updir\". Give both, or neither");
  EXPECT_EQ(errorOf("camera {\n updir = (0, 1, 0); }"),
            "test.ray:3:2: \"updir\" is given, but not \"viewdir\". Give both, or neither");
  EXPECT_EQ(
      errorOf("camera { quaternian = (0,0,0,1) viewdir = (0,0,1) updir = (0,1,0) }"),
      "test.ray:2:10: \"quaternian\" is given, and so are \"viewdir\" and \"updir\". Give one "
      "or the other");
}

TEST(RayCamera, NeedsAPlaneForItsPicture) {
  const std::string parallel =
      "test.ray:2:10: \"viewdir\" and \"updir\" are zero, parallel or too large. Choose two unit "
      "vectors at a right angle";
  EXPECT_EQ(errorOf("camera { viewdir = (0, 0, 1) updir = (0, 0, -2) }"), parallel);
  EXPECT_EQ(errorOf("camera { viewdir = (0, 0, 0) updir = (0, 1, 0) }"), parallel);
  EXPECT_EQ(errorOf("camera { viewdir = (0, 0, 1e200) updir = (0, 1e200, 0) }"), parallel);
  EXPECT_EQ(errorOf("camera { quaternian = (0, 0, 0, 0) }"),
            "test.ray:2:10: \"quaternian\" is zero or too large. No rotation is (0, 0, 0, 1)");
  for (const std::string angle : {"0", "180", "-45", "1e9"}) {
    EXPECT_EQ(errorOf("camera { fov = " + angle + "; }"),
              "test.ray:2:16: expected an angle between 0 and 180 degrees, found \"" + angle +
                  "\". Choose another fov");
  }
  EXPECT_EQ(errorOf("camera { aspectratio = 0; }"),
            "test.ray:2:24: expected a ratio above 0, found \"0\". Choose another aspectratio");
}

TEST(RayCamera, IsChangedByALaterOne) {
  const auto scene = readStatements(
      "camera { position = (1, 2, 3); fov = 90; }\ncamera { viewdir = (0, 0, 1) updir = (0, 1, 0) "
      "}");
  expectNear(scene.view->eye, {1, 2, 3});
  expectNear(scene.view->look, {0, 0, 1});
  expectNear(scene.view->v, {0, 2, 0});
  EXPECT_EQ(scene.remarks,
            std::vector<std::string>({"test.ray:3:8: there is more than one camera; what the later "
                                      "one says counts"}));
}

TEST(RayCamera, RemarksOnRepeats) {
  const auto scene = readStatements("camera { fov = 30; fov = 90; }");
  expectNear(scene.view->v, {0, 2, 0});
  EXPECT_EQ(scene.remarks, std::vector<std::string>(
                               {"test.ray:2:20: \"fov\" of \"camera\" is given a second time, "
                                "after line 2, column 10; the later one counts"}));
}

TEST(RayCamera, TellsWhatItExpects) {
  EXPECT_EQ(errorOf("camera { position (0, 0, 0) }"),
            "test.ray:2:19: expected '=' behind \"position\", found '('. Write position = ...");
  EXPECT_EQ(errorOf("camera { position = (0, 0) }"),
            "test.ray:2:26: expected ',', found ')'. Three numbers belong here: (x, y, z)");
  EXPECT_EQ(errorOf("camera { position = (0, 0, 0, 0) }"),
            "test.ray:2:29: expected ')', found ','. Three numbers belong here: (x, y, z)");
  EXPECT_EQ(errorOf("camera { position = 3 }"),
            "test.ray:2:21: expected '(', found \"3\". Three numbers belong here: (x, y, z)");
  EXPECT_EQ(errorOf("camera { quaternian = (0, 0, 1) }"),
            "test.ray:2:31: expected ',', found ')'. Four numbers belong here: (a, b, c, d)");
  EXPECT_EQ(errorOf("camera { positon = (0, 0, 0) }"),
            "test.ray:2:10: expected '}' or a keyword of \"camera\", found \"positon\". Did you "
            "mean \"position\"?");
  EXPECT_EQ(errorOf("camera { zoom = 2 }"),
            "test.ray:2:10: expected '}' or a keyword of \"camera\", found \"zoom\". It may hold "
            "position, viewdir, updir, quaternian, fov and aspectratio");
}

}  // namespace
}  // namespace planetree::test
