#include "unit/scene/ray_text.hpp"

#include <gtest/gtest.h>

#include <string>

// What all statements have in common.
namespace planetree::test {
namespace {

using namespace std::string_literals;

TEST(RayText, BeginsWithTheNameOfTheFormatAndAVersion) {
  EXPECT_EQ(readText("SBT-raytracer 1.0").shapes.size(), 0u);
  EXPECT_EQ(readText("/* old */ SBT-raytracer\n1.1;; sphere {}").shapes.size(), 1u);
  EXPECT_EQ(readText("\xEF\xBB\xBFSBT-raytracer 1.0 sphere {}").shapes.size(), 1u);
  const std::string advice = ". If this is a .ray scene, begin it with SBT-raytracer 1.0";
  EXPECT_EQ(
      errorOfText(""),
      "test.ray:1:1: expected SBT-raytracer at the beginning, found the end of the file" + advice);
  EXPECT_EQ(errorOfText(" sphere {}"),
            "test.ray:1:2: expected SBT-raytracer at the beginning, found \"sphere\"" + advice);
  EXPECT_EQ(errorOfText("SBT-raytracer1.0"),
            "test.ray:1:1: expected SBT-raytracer at the beginning, found \"SBT\"" + advice);
  EXPECT_EQ(errorOfText("SBT-raytracer { }"),
            "test.ray:1:15: expected a number, found '{'. Numbers look like 2, -0.5 or 1e-3");
}

TEST(RayText, OfLaterVersionsIsRefused) {
  const std::string advice =
      "expected a version up to 1.1, found \"1.2\". Save the scene in version 1.1 or an older one";
  EXPECT_EQ(errorOfText("SBT-raytracer 1.2 sphere {}"), "test.ray:1:15: " + advice);
  EXPECT_EQ(errorOfText("SBT-raytracer 1.10000001").substr(0, 45),
            "test.ray:1:15: expected a version up to 1.1, ");
  EXPECT_NE(errorOfText("SBT-raytracer -1"), "no error");
}

TEST(RayText, MayHaveCommentsAndBlanksAnywhere) {
  const auto scene = readText(
      "//first\r\nSBT-raytracer/**/1.0\t// version\n/* * / // /* \n\n **/translate(1,// "
      "x\n2/*y*/,3,"
      "/*what*/sphere/**/{}/**/)/**/;//end");
  ASSERT_EQ(scene.shapes.size(), 1u);
  EXPECT_EQ(scene.shapes[0].placement.origin(), (Vec3d{1, 2, 3}));
}

TEST(RayText, CountsLinesAndColumnsThroughComments) {
  EXPECT_EQ(errorOf("/* one\n two */ x").substr(0, 14), "test.ray:3:9: ");
  EXPECT_EQ(errorOf("// one\r\n\r\n  x").substr(0, 14), "test.ray:4:3: ");
  EXPECT_EQ(errorOf("/* \xC3\xA4 */ x").substr(0, 15), "test.ray:2:10: ");  // in bytes
}

TEST(RayText, LinesMayEndAsOnOldMacs) {
  EXPECT_EQ(errorOfText("SBT-raytracer 1.0\r// one\r\r  x").substr(0, 14), "test.ray:4:3: ");
  EXPECT_EQ(errorOfText("SBT-raytracer 1.0\r/* one\r two */ x").substr(0, 14), "test.ray:3:9: ");
  EXPECT_EQ(errorOfText("SBT-raytracer 1.0\r/* \r\n\n\r*/\r\nx").substr(0, 14), "test.ray:6:1: ");
  EXPECT_EQ(errorOfText("SBT-raytracer 1.0 // version\r x").substr(0, 14), "test.ray:2:2: ");
  EXPECT_EQ(errorOf("/*\r*/ x").substr(0, 14), "test.ray:3:4: ");
  EXPECT_EQ(readText("SBT-raytracer 1.0 // one\rsphere {} // two\rsphere {}").shapes.size(), 2u);
  EXPECT_EQ(errorOf("sphere { name = \"a\r\" }").substr(0, 33),
            "test.ray:2:17: expected a closing");
}

TEST(RayText, NeedsEndsOfCommentsAndStrings) {
  EXPECT_EQ(errorOf("sphere {} /* a\nb"),
            "test.ray:2:11: expected the end of the comment, found the end of the file. Close the "
            "comment that begins here with */");
  EXPECT_EQ(errorOf("/*/"),
            "test.ray:2:1: expected the end of the comment, found the end of the file. Close the "
            "comment that begins here with */");
  const std::string unclosed =
      "expected a closing quote in the line of the opening one, found none. Close the text that "
      "begins here with \"";
  EXPECT_EQ(errorOf("sphere { name = \"a"), "test.ray:2:17: " + unclosed);
  EXPECT_EQ(errorOf("sphere { name = \"a\n\" }"), "test.ray:2:17: " + unclosed);
  EXPECT_EQ(errorOf("/"),
            "test.ray:2:1: expected a keyword, a number or a bracket, found '/'. Names with other "
            "characters than letters, digits and _ stand in quotes");
}

TEST(RayText, RefusesBytesThatMeanNothing) {
  const std::string advice =
      ". Names with other characters than letters, digits and _ stand in quotes";
  EXPECT_EQ(
      errorOf("sphere {}\n \0"s),
      "test.ray:3:2: expected a keyword, a number or a bracket, found the byte 0x00" + advice);
  EXPECT_EQ(
      errorOf("sphere { \xFF }"),
      "test.ray:2:10: expected a keyword, a number or a bracket, found the byte 0xFF" + advice);
  EXPECT_EQ(errorOf("[1]"),
            "test.ray:2:1: expected a keyword, a number or a bracket, found '['" + advice);
  EXPECT_EQ(errorOf("sphere { name = \"a\0b\" }"s),
            "test.ray:2:19: expected a text that can be read, found the byte 0x00. Take control "
            "characters out of the quotes");
}

TEST(RayText, NeedsSemicolonsNowhereAndAllowsThemBetweenStatements) {
  const auto without = readStatements(
      "camera { fov = 40 aspectratio = 2 } material = { name gold diffuse = (1, 0, 0) } "
      "translate(1, 0, 0, { material = gold sphere { name a } box {} }) cone { capped = false }");
  const auto with = readStatements(
      ";;camera {; fov = 40;; aspectratio = 2; };; material = { name = gold;; diffuse = (1, 0, 0); "
      "};; translate(1, 0, 0, {; material = gold;; sphere { name = a; };; box {;}; };; );; "
      "cone { capped = false;; };;");
  ASSERT_EQ(without.shapes.size(), 3u);
  ASSERT_EQ(with.shapes.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(with.shapes[i].material, without.shapes[i].material);
    EXPECT_EQ(with.shapes[i].placement, without.shapes[i].placement);
    EXPECT_EQ(with.shapes[i].name, without.shapes[i].name);
  }
}

TEST(RayText, HasNumbersInManySpellings) {
  const auto scene = readStatements(
      "translate(.5, -2., +1e-3, sphere {}) translate(1E2, -.5e+1, 007, sphere {})"
      "translate(-0, 1e-999, +.25, sphere {})");
  EXPECT_EQ(scene.shapes[0].placement.origin(), (Vec3d{0.5, -2, 1e-3}));
  EXPECT_EQ(scene.shapes[1].placement.origin(), (Vec3d{100, -5, 7}));
  EXPECT_EQ(scene.shapes[2].placement.origin(), (Vec3d{0, 0, 0.25}));
}

TEST(RayText, RefusesWhatIsNoNumber) {
  for (const std::string word :
       {"1.2.3", "1x", "0x10", "--1", "+-1", "1e", ".", "-", "1-2", "1_0"}) {
    EXPECT_EQ(errorOf("scale(" + word + ", sphere {})"),
              "test.ray:2:7: expected a number, found \"" + word +
                  "\". Numbers look like 2, -0.5 or 1e-3");
  }
  for (const std::string word : {"1e999", "-1e999", "-inf", "+nan"}) {
    EXPECT_EQ(errorOf("scale(" + word + ", sphere {})"),
              "test.ray:2:7: expected a number, found \"" + word +
                  "\". It must be finite, and less than 1.8e308 in magnitude");
  }
  EXPECT_EQ(errorOf("scale(inf, sphere {})"),
            "test.ray:2:7: expected a number, found \"inf\". Numbers look like 2, -0.5 or 1e-3");
}

TEST(RayText, TellsTheNearestKeyword) {
  EXPECT_EQ(errorOf("shpere {}"),
            "test.ray:2:1: expected a camera, light, material, shape, transform or group, found "
            "\"shpere\". Did you mean \"sphere\"?");
  EXPECT_EQ(errorOf("Sphere {}"),
            "test.ray:2:1: expected a camera, light, material, shape, transform or group, found "
            "\"Sphere\". Did you mean \"sphere\"?");
  EXPECT_EQ(errorOf("teapot {}"),
            "test.ray:2:1: expected a camera, light, material, shape, transform or group, found "
            "\"teapot\". A scene has cameras, lights, materials, shapes, transforms and groups in "
            "braces");
  EXPECT_EQ(errorOf("sphere { radius = 2; }"),
            "test.ray:2:10: expected '}' or a keyword of \"sphere\", found \"radius\". It may hold "
            "material and name");
  EXPECT_EQ(errorOf("sphere { \"name\" = a }"),
            "test.ray:2:10: expected '}' or a keyword of \"sphere\", found the text \"name\". Did "
            "you mean \"name\"?");
  EXPECT_EQ(errorOf("translate(0, 0, 0, shere {})"),
            "test.ray:2:20: expected a shape, transform or group to be transformed, found "
            "\"shere\". Did you mean \"sphere\"?");
}

TEST(RayText, TellsWhichBracketIsMissing) {
  EXPECT_EQ(errorOf("sphere"),
            "test.ray:2:7: expected '{' behind \"sphere\", found the end of the file. Write sphere "
            "{ ... }");
  EXPECT_EQ(errorOf("cone {\n height = 2;\n"),
            "test.ray:4:1: expected the '}' that ends \"cone\" at line 2, column 6, found the end "
            "of the file. Add it where the block is to end");
  EXPECT_EQ(errorOf("sphere {} }"),
            "test.ray:2:11: expected a statement, found '}'. There is one '}' too many, or a '{' "
            "is missing before it");
  EXPECT_EQ(errorOf("{ sphere {}\n{ box {} }"),
            "test.ray:3:11: expected the '}' that ends the group at line 2, column 1, found the "
            "end of the file. Add it where the group is to end");
  EXPECT_EQ(errorOf("translate(0, 0, 0,\n sphere {}"),
            "test.ray:3:11: expected the ')' that ends the \"translate\" at line 2, column 1, "
            "found the end of the file. Add it where the \"translate\" is to end");
}

TEST(RayText, NeedsNamesWhereTheyBelong) {
  EXPECT_EQ(
      errorOf("sphere { name = 3.5; }"),
      "test.ray:2:17: expected the name of a shape, found \"3.5\". Names with other characters "
      "than letters, digits and _ stand in quotes");
  EXPECT_EQ(errorOf("material = { name = \"\"; }"),
            "test.ray:2:21: expected the name of a material, found the text \"\". Put a name "
            "between the quotes");
  EXPECT_EQ(readStatements("sphere { name \"a (b) // c\" }").shapes[0].name, "a (b) // c");
  EXPECT_EQ(readStatements("sphere { name = camera }").shapes[0].name, "camera");
}

TEST(RayText, NamesMayBeginWithADigit) {
  const auto scene = readStatements(
      "material={name=3d; index=2}sphere{material=3d}material={name 4 index=4}sphere{material=4;"
      "name=1e5}trimesh{name _9 points=((0,0,0),(1,0,0)) materials=(3d,4)}");
  ASSERT_EQ(scene.shapes.size(), 3u);
  EXPECT_EQ(scene.materials.at(scene.shapes[0].material).name, "3d");
  EXPECT_EQ(scene.materials.at(scene.shapes[1].material).name, "4");
  EXPECT_EQ(scene.shapes[1].name, "1e5");
  EXPECT_EQ(scene.shapes[2].name, "_9");
  const std::string advice =
      ". Names with other characters than letters, digits and _ stand in quotes";
  for (const std::string word : {"-3", "3.d", "+3d", "3-d", ".5"}) {
    EXPECT_EQ(errorOf("sphere { name = " + word + " }"),
              "test.ray:2:17: expected the name of a shape, found \"" + word + "\"" + advice);
  }
  EXPECT_EQ(errorOf("material = { name = 3d } sphere { material = 3e }"),
            "test.ray:2:46: there is no material \"3e\" so far. Define it before it is used");
  EXPECT_EQ(errorOf("scale(3d, sphere {})"),
            "test.ray:2:7: expected a number, found \"3d\". Numbers look like 2, -0.5 or 1e-3");
}

TEST(RayText, KnowsTheNameOfItsFile) {
  const std::string text = "SBT-raytracer 1.0";
  EXPECT_EQ(scene::readRayScene(std::as_bytes(std::span(text)), "folder/a.ray", "").name, "a.ray");
}

TEST(RayText, MustBeThere) {
  try {
    static_cast<void>(scene::readRayScene("no/such/scene.ray"));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::FileNotReadable);
    EXPECT_EQ(error.file(), "no/such/scene.ray");
  }
}

}  // namespace
}  // namespace planetree::test
