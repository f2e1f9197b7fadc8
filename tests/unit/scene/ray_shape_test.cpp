#include "unit/scene/ray_text.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <variant>
#include <vector>

// Shapes but for meshes, transforms and groups.
namespace planetree::test {
namespace {

using scene::Affine;
using scene::ConeShape;
using scene::SceneDescription;

void expectNear(const Vec3d& a, const Vec3d& b) {
  constexpr double kTolerance = 1e-12;
  EXPECT_NEAR(a.x, b.x, kTolerance);
  EXPECT_NEAR(a.y, b.y, kTolerance);
  EXPECT_NEAR(a.z, b.z, kTolerance);
}

/// Where the only shape of the scene has what is at p in its own space.
Vec3d placed(const std::string& statements, const Vec3d& p) {
  return readStatements(statements).shapes.at(0).placement.point(p);
}

TEST(RayShape, IsWhatItsKeywordSays) {
  const SceneDescription scene =
      readStatements("sphere {} box { name = b } square { name c } cylinder {} cone {}");
  ASSERT_EQ(scene.shapes.size(), 5u);
  EXPECT_TRUE(std::holds_alternative<scene::UnitSphere>(scene.shapes[0].shape));
  EXPECT_TRUE(std::holds_alternative<scene::UnitBox>(scene.shapes[1].shape));
  EXPECT_TRUE(std::holds_alternative<scene::UnitSquare>(scene.shapes[2].shape));
  EXPECT_TRUE(std::get<scene::UnitCylinder>(scene.shapes[3].shape).isCapped);
  EXPECT_TRUE(std::holds_alternative<ConeShape>(scene.shapes[4].shape));
  EXPECT_EQ(scene.shapes[0].name, "");
  EXPECT_EQ(scene.shapes[1].name, "b");
  EXPECT_EQ(scene.shapes[2].name, "c");
  EXPECT_EQ(scene.shapes[0].placement, Affine());
}

TEST(RayShape, ConesHaveHeightRadiiAndCaps) {
  const SceneDescription scene = readStatements(
      "cone {} cone { capped = false; height = -2; bottom_radius = -3; top_radius = 0.5; "
      "name = c } cone { capped = true }");
  const auto& plain = std::get<ConeShape>(scene.shapes.at(0).shape);
  EXPECT_TRUE(plain.isCapped);
  EXPECT_EQ(plain.height, 1.0);
  EXPECT_EQ(plain.bottomRadius, 1.0);
  EXPECT_EQ(plain.topRadius, 0.0);
  const auto& open = std::get<ConeShape>(scene.shapes.at(1).shape);
  EXPECT_FALSE(open.isCapped);
  EXPECT_EQ(open.height, -2.0);
  EXPECT_EQ(open.bottomRadius, 3.0);
  EXPECT_EQ(open.topRadius, 0.5);
  EXPECT_TRUE(std::get<ConeShape>(scene.shapes.at(2).shape).isCapped);
}

TEST(RayShape, ConesNeedASurface) {
  EXPECT_EQ(errorOf("cone { height = 0; }"),
            "test.ray:2:1: the height of the cone is 0. Give it another height");
  EXPECT_EQ(errorOf("cone { bottom_radius = 0; }"),
            "test.ray:2:1: both radii of the cone are 0. Give it another bottom_radius or "
            "top_radius");
  EXPECT_EQ(errorOf("cone { capped = 1; }"),
            "test.ray:2:17: expected true or false, found \"1\". Write one of the two");
}

TEST(RayShape, RemarksOnRepeats) {
  const SceneDescription scene = readStatements("sphere { name = a; name = b; }");
  EXPECT_EQ(scene.shapes[0].name, "b");
  EXPECT_EQ(scene.remarks,
            std::vector<std::string>({"test.ray:2:20: \"name\" of \"sphere\" is given a second "
                                      "time, after line 2, column 10; the later one counts"}));
}

TEST(RayTransform, MovesTurnsAndScales) {
  expectNear(placed("translate(1, 2, 3, sphere {})", {1, 1, 1}), {2, 3, 4});
  expectNear(placed("scale(2, sphere {})", {1, 2, 3}), {2, 4, 6});
  expectNear(placed("scale(2, -3, 4, sphere {})", {1, 1, 1}), {2, -3, 4});
  expectNear(placed("rotate(0, 0, 2, 1.5707963267948966, sphere {})", {1, 0, 0}), {0, 1, 0});
  expectNear(placed("transform((1, 2, 3, 4), (0, 1, 0, 5), (0, 0, 1, 6), (0, 0, 0, 1), sphere {})",
                    {1, 1, 1}),
             {10, 6, 7});
}

TEST(RayTransform, NestsInnermostFirst) {
  expectNear(placed("translate(1, 0, 0, scale(2, rotate(0, 0, 1, 1.5707963267948966, sphere {})))",
                    {1, 0, 0}),
             {1, 2, 0});
  expectNear(placed("scale(2, translate(1, 0, 0, { { scale(3, 1, 1, sphere {}) } }))", {1, 1, 1}),
             {8, 2, 2});
}

TEST(RayTransform, OfAGroupIsThatOfAllInIt) {
  const SceneDescription scene = readStatements(
      "translate(1, 0, 0, { sphere {} translate(0, 1, 0, box {}) {} { cone {} } }) sphere {}");
  ASSERT_EQ(scene.shapes.size(), 4u);
  EXPECT_EQ(scene.shapes[0].placement.origin(), (Vec3d{1, 0, 0}));
  EXPECT_EQ(scene.shapes[1].placement.origin(), (Vec3d{1, 1, 0}));
  EXPECT_EQ(scene.shapes[2].placement.origin(), (Vec3d{1, 0, 0}));
  EXPECT_EQ(scene.shapes[3].placement.origin(), (Vec3d{0, 0, 0}));
}

TEST(RayTransform, ThatIsSingularIsAnErrorAtItsPlace) {
  const auto singular = [](const std::string& place, const std::string& keyword) {
    return "test.ray:" + place + ": this \"" + keyword +
           "\" is singular: it makes shapes flat, or is beyond all numbers. Scale by a small "
           "number "
           "instead of 0";
  };
  EXPECT_EQ(errorOf("scale(1, 0, 1, sphere {})"), singular("2:1", "scale"));
  EXPECT_EQ(errorOf("translate(1, 0, 0,\n  scale(0, sphere {}))"), singular("3:3", "scale"));
  EXPECT_EQ(errorOf("transform((1, 2, 3, 0), (2, 4, 6, 0), (0, 0, 1, 0), (0, 0, 0, 1), box {})"),
            singular("2:1", "transform"));
  EXPECT_EQ(errorOf("transform((.1,.2,.3,0), (.4,.5,.6,0), (.7,.8,.9,0), (0,0,0,1), sphere {})"),
            singular("2:1", "transform"));
  EXPECT_EQ(errorOf("scale(1e200, box {})"), singular("2:1", "scale"));
  EXPECT_EQ(errorOf("rotate(1, 2, 3, 1, scale(1, 1e-9, 1, rotate(3, 2, 1, 1, box {})))"),
            "no error");
  EXPECT_EQ(errorOf("rotate(0, 0, 0, 1, box {})"),
            "test.ray:2:1: the axis of the rotation is (0, 0, 0). Choose another axis: (0, 0, 1) "
            "turns x to y");
}

TEST(RayTransform, ThatIsSingularWithTheOthersIsAnErrorWhereItBecomesSo) {
  const std::string beyond =
      " and those around it make shapes too small or too large. Scale by numbers nearer to 1";
  EXPECT_EQ(errorOf("scale(1e-90, scale(1e-90, box {}))"),
            "test.ray:2:14: this \"scale\"" + beyond);
  EXPECT_EQ(errorOf("scale(1e90, translate(1e300, 0, 0, box {}))"),
            "test.ray:2:13: this \"translate\"" + beyond);
}

TEST(RayTransform, HasNoPerspective) {
  EXPECT_EQ(errorOf("transform((1,0,0,0), (0,1,0,0), (0,0,1,0),\n (0,0,1,1), box {})"),
            "test.ray:3:2: the last row of the transform is not (0, 0, 0, 1). Projections cannot "
            "be used. If the matrix is for rows of points, write its columns as rows");
}

TEST(RayTransform, TakesOneThing) {
  EXPECT_EQ(errorOf("scale(2, sphere {} sphere {})"),
            "test.ray:2:20: expected ')' of the \"scale\" at line 2, column 1, found \"sphere\". A "
            "transform takes one shape, transform or group; put several into a group, { ... }");
  EXPECT_EQ(errorOf("scale(2, material = {})"),
            "test.ray:2:10: expected a shape, transform or group to be transformed, found "
            "\"material\". Put it into the shape, or both into a group, { material = ...; ... }");
  EXPECT_EQ(errorOf("translate(0,0,0,material={diffuse=(1,0,0)} sphere{})").substr(0, 15),
            "test.ray:2:17: ");
  EXPECT_EQ(errorOf("translate(0,0,0,{material={diffuse=(1,0,0)} sphere{}})"), "no error");
  EXPECT_EQ(errorOf("translate(1, 0, 0)"),
            "test.ray:2:18: expected ',' behind the number, found ')'. Write translate(x, y, z, "
            "what)");
  EXPECT_EQ(errorOf("rotate(1, 0, 0, sphere {})"),
            "test.ray:2:17: expected a number, found \"sphere\". Numbers look like 2, -0.5 or "
            "1e-3");
  EXPECT_EQ(errorOf("scale(1, 2, sphere {})"),
            "test.ray:2:13: expected a number, found \"sphere\". Numbers look like 2, -0.5 or "
            "1e-3");
  EXPECT_EQ(errorOf("transform((1,0,0), sphere {})"),
            "test.ray:2:17: expected ',', found ')'. Four numbers belong here: (a, b, c, d)");
  EXPECT_EQ(errorOf("translate{}"),
            "test.ray:2:10: expected '(' behind \"translate\", found '{'. Write translate(x, y, z, "
            "what)");
}

}  // namespace
}  // namespace planetree::test
