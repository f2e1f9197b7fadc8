#include "scene/build_scene.hpp"
#include "scene/json_format/object_syntax.hpp"
#include "scene/json_format/parse_json.hpp"
#include "scene/read_scene.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planetree::test {
namespace {

using namespace scene;

/// One triangle with a texture and two materials, as a model may be.
SceneDescription triangleModel() {
  auto mesh = std::make_shared<MeshShape>();
  mesh->positions = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}};
  mesh->faces = {{0, 1, 2}};
  mesh->faceMaterials = {1};
  SceneDescription model;
  model.materials.resize(2);
  model.materials[1].name = "leaf";
  model.materials[1].diffuse = {.value = {0, 1, 0}, .texture = 0};
  model.textures.emplace_back(1, 1, std::vector<Vec3f>{{1, 1, 1}});
  model.shapes.push_back({.shape = std::shared_ptr<const MeshShape>(mesh), .placement = {}});
  model.remarks = {"a remark"};
  return model;
}

/// What files were asked for, and one colour or one triangle in each of them. Names with "missing"
/// are.
struct Files {
  std::vector<std::filesystem::path> asked;
  SceneFileReaders readers{.model =
                               [this](const std::filesystem::path& path) {
                                 ask(path);
                                 return triangleModel();
                               },
                           .texture =
                               [this](const std::filesystem::path& path) {
                                 ask(path);
                                 return Texture(1, 1, std::vector<Vec3f>{{0.5f, 0.25f, 0.125f}});
                               }};

  Files() = default;
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

 private:
  void ask(const std::filesystem::path& path) {
    asked.push_back(path);
    if (path.string().find("missing") != std::string::npos) {
      throw Error(ErrorCode::FileNotReadable, "no such file", "Look for it.",
                  {.file = path.string()});
    }
  }
};

SceneDescription readText(std::string_view text, Files& files) {
  return readJsonScene(std::as_bytes(std::span(text)), "test.json", "folder", files.readers);
}

SceneDescription readText(std::string_view text) {
  Files files;
  return readText(text, files);
}

void expectNear(const Vec3d& a, const Vec3d& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

TEST(JsonScene, MayBeEmpty) {
  const SceneDescription scene = readText("\xEF\xBB\xBF {} \n");
  EXPECT_EQ(scene.name, "test.json");
  EXPECT_FALSE(scene.view);
  EXPECT_TRUE(scene.shapes.empty());
  EXPECT_FALSE(scene.background);
}

TEST(JsonScene, HasItsCameraAndLights) {
  const SceneDescription scene = readText(R"({
    "camera": {"position": [0, 0, 4], "look_at": [0, 0, 0], "up": [0, 3, 1], "fov": 90,
               "aspect_ratio": 2},
    "ambient_light": "#ff3300",
    "lights": [{"type": "point", "position": [1, 2, 3], "colour": [1, 0.5, 2], "linear": 0.25},
               {"type": "directional", "direction": [0, -2, 0], "colour": "#0000ff"}]})");
  ASSERT_TRUE(scene.view);
  expectNear(scene.view->eye, {0, 0, 4});
  expectNear(scene.view->look, {0, 0, -1});
  expectNear(scene.view->u, {4, 0, 0});
  expectNear(scene.view->v, {0, 2, 0});
  expectNear(scene.ambientLight, {1, 0.2, 0});
  ASSERT_EQ(scene.pointLights.size(), 1u);
  expectNear(scene.pointLights[0].colour, {1, 0.5, 2});
  EXPECT_EQ(scene.pointLights[0].constant, 1.0);
  EXPECT_EQ(scene.pointLights[0].linear, 0.25);
  EXPECT_EQ(scene.pointLights[0].quadratic, 0.0);
  ASSERT_EQ(scene.directionalLights.size(), 1u);
  expectNear(scene.directionalLights[0].direction, {0, -1, 0});
}

TEST(JsonScene, HasMaterialsByNameAndInPlace) {
  Files files;
  const SceneDescription scene = readText(R"({
    "shapes": [{"type": "sphere", "material": "wood"}, {"type": "box"}, {"type": "square"},
               {"type": "box", "material": {"diffuse": [1, 0, 0], "ambient": [0, 0, 0.5]}}],
    "materials": {"wood": {"diffuse": {"texture": "wood.png", "factor": [1, 0.5, 1]},
                           "index": 1.5, "shininess": {"texture": "wood.png", "factor": 64}},
                  "glow": {"emissive": [1, 1, 1]}}})",
                                          files);
  ASSERT_EQ(scene.shapes.size(), 4u);
  const Material& wood = scene.materials[scene.shapes[0].material];
  EXPECT_EQ(wood.name, "wood");
  EXPECT_EQ(wood.diffuse.texture, 0u);
  EXPECT_EQ(wood.ambient.texture, 0u) << "ambient is as diffuse";
  expectNear(wood.diffuse.value, {1, 0.5, 1});
  EXPECT_EQ(wood.index.value, 1.5);
  EXPECT_EQ(wood.shininess.texture, 0u);
  EXPECT_EQ(wood.shininess.value, 64.0);
  EXPECT_EQ(files.asked, std::vector<std::filesystem::path>{"folder/wood.png"}) << "once";
  EXPECT_EQ(scene.shapes[1].material, scene.shapes[2].material) << "one grey for all";
  expectNear(scene.materials[scene.shapes[1].material].diffuse.value, {0.8, 0.8, 0.8});
  const Material& red = scene.materials[scene.shapes[3].material];
  expectNear(red.diffuse.value, {1, 0, 0});
  expectNear(red.ambient.value, {0, 0, 0.5});
  EXPECT_EQ(red.shininess.value, 32.0);
  EXPECT_EQ(red.index.value, 1.0);
}

TEST(JsonScene, DoesStepsInTheirOrderAndThenMovesToThePosition) {
  const SceneDescription scene = readText(R"({"shapes": [
    {"type": "group", "position": [0, 0, 100], "transform": [{"scale": 2}], "children": [
      {"type": "box", "size": [1, 2, 3], "position": [0, 10, 0],
       "transform": [{"translate": [1, 0, 0]}, {"rotate": {"axis": [0, 0, 5], "degrees": 90}},
                     {"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 7], [0, 0, 0, 1]]}]}]}]})");
  ASSERT_EQ(scene.shapes.size(), 1u);
  // (0.5, 1, 1.5) is a corner of the box; (1.5, 1, 1.5) (-1, 1.5, 1.5) (-1, 1.5, 8.5)
  // (-1, 11.5, 8.5), and in the group (-2, 23, 17), (-2, 23, 117).
  expectNear(scene.shapes[0].placement.point({0.5, 0.5, 0.5}), {-2, 23, 117});
}

TEST(JsonScene, HasTheSizesOfShapes) {
  const SceneDescription scene = readText(R"({"shapes": [
    {"type": "sphere", "radius": 3, "name": "ball"}, {"type": "square", "size": 4},
    {"type": "cylinder", "radius": 2, "height": 5, "capped": false},
    {"type": "cone", "bottom_radius": 2, "top_radius": 1, "height": 3}]})");
  ASSERT_EQ(scene.shapes.size(), 4u);
  EXPECT_EQ(scene.shapes[0].name, "ball");
  expectNear(scene.shapes[0].placement.point({1, 0, 0}), {3, 0, 0});
  expectNear(scene.shapes[1].placement.point({0.5, -0.5, 0}), {2, -2, 0});
  expectNear(scene.shapes[2].placement.point({1, 0, 1}), {2, 0, 5});
  EXPECT_FALSE(std::get<UnitCylinder>(scene.shapes[2].shape).isCapped);
  const auto& cone = std::get<ConeShape>(scene.shapes[3].shape);
  EXPECT_EQ(cone.bottomRadius, 2.0);
  EXPECT_EQ(cone.topRadius, 1.0);
  EXPECT_EQ(cone.height, 3.0);
  EXPECT_TRUE(cone.isCapped);
}

TEST(JsonScene, PlacesModelsWithTheirMaterials) {
  Files files;
  const SceneDescription scene = readText(R"({
    "background": "#ffffff", "materials": {"paint": {"diffuse": [1, 0, 0]}},
    "shapes": [{"type": "model", "file": "a.obj"},
               {"type": "group", "material": "paint", "children": [
                 {"type": "model", "file": "a.obj", "position": [9, 0, 0]}]}]})",
                                          files);
  EXPECT_EQ(files.asked, std::vector<std::filesystem::path>{"folder/a.obj"}) << "once";
  EXPECT_EQ(scene.remarks, std::vector<std::string>{"a remark"});
  ASSERT_EQ(scene.shapes.size(), 2u);
  const auto& own = *std::get<std::shared_ptr<const MeshShape>>(scene.shapes[0].shape);
  ASSERT_EQ(own.faceMaterials.size(), 1u);
  const Material& leaf = scene.materials.at(own.faceMaterials[0]);
  EXPECT_EQ(leaf.name, "leaf");
  EXPECT_EQ(leaf.diffuse.texture, 1u) << "behind that of the background";
  const auto& painted = *std::get<std::shared_ptr<const MeshShape>>(scene.shapes[1].shape);
  EXPECT_TRUE(painted.faceMaterials.empty());
  EXPECT_EQ(scene.materials.at(scene.shapes[1].material).name, "paint");
  EXPECT_EQ(BuiltScene(scene).tree().statistics().referenceCount, 2u);
}

TEST(JsonScene, FitsModelsIntoBoxes) {
  const SceneDescription scene = readText(R"({"shapes": [
    {"type": "model", "file": "a.obj", "transform": [{"translate": [5, 5, 5]}],
     "fit": {"lower": [-4, 1, -1], "upper": [4, 9, 3]}}]})");
  // The triangle is 2 wide and 4 high: it becomes 4 wide, 8 high.
  const Affine& placement = scene.shapes.at(0).placement;
  const auto near = [](const Vec3d& a, const Vec3d& b) { return length(a - b) < 1e-5; };
  EXPECT_TRUE(near(placement.point({0, 0, 0}), {-2, 1, 1}));
  EXPECT_TRUE(near(placement.point({2, 0, 0}), {2, 1, 1}));
  EXPECT_TRUE(near(placement.point({0, 4, 0}), {-2, 9, 1}));
}

TEST(JsonScene, HasACubeMapOrOneColourAround) {
  Files files;
  const SceneDescription map = readText(
      R"({"background": {"negx": "b", "posx": "a", "posy": "c", "negy": "d", "posz": "e",
          "negz": "f"}})",
      files);
  ASSERT_TRUE(map.background);
  EXPECT_EQ(files.asked.at(map.background->textures[0]), "folder/a");
  EXPECT_EQ(files.asked.at(map.background->textures[1]), "folder/b");
  EXPECT_EQ(files.asked.at(map.background->textures[5]), "folder/f");
  const BuiltScene blue(readText(R"({"background": [0.25, 0.5, 1]})"));
  expectNear(blue.background({0.3, -2, 1}), {0.25, 0.5, 1});
}

/// A scene that is refused, where, and what the error must say.
struct Refused {
  std::string text;
  std::int64_t line;
  std::int64_t column;
  std::string said;
};

void PrintTo(const Refused& refused, std::ostream* out) {
  *out << refused.text;
}

class JsonRefusal : public testing::TestWithParam<Refused> {};

TEST_P(JsonRefusal, NamesThePlaceAndTheCulprit) {
  const auto& [text, line, column, said] = GetParam();
  try {
    static_cast<void>(readText(text));
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.file(), "test.json");
    EXPECT_EQ(error.line(), line) << error.what();
    EXPECT_EQ(error.column(), column) << error.what();
    EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
    EXPECT_FALSE(error.advice().empty());
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, JsonRefusal,
    testing::Values(Refused{"", 1, 1, "unexpected end of input"},
                    Refused{"{\n  \"shapes\": [", 2, 14, "unexpected end of input"},
                    Refused{"{\n \"shapes\": [}", 2, 13, "unexpected '}'"},
                    Refused{"{} {}", 1, 4, "unexpected '{'"},
                    Refused{"{\"title\": \"a\" \"b\"}", 1, 15, "unexpected string literal"},
                    Refused{"{\"title\": 12 345}", 1, 14, "unexpected number literal"},
                    Refused{"{\"title\": tru}", 1, 14, "invalid literal"},
                    Refused{"{\"title\": \"a\nb\"}", 1, 13, "control character"},
                    Refused{"{\"title\": \"\xC3(\"}", 1, 13, "ill-formed UTF-8"},
                    Refused{"{\"camera\": 1e999}", 1, 12, "number overflow"},
                    Refused{"{\"title\": \"a\", \"title\": \"b\"}", 1, 16, "there twice"},
                    Refused{"// no\n{}", 1, 1, "invalid literal"}, Refused{"[]", 1, 1, "object"},
                    Refused{"null", 1, 1, "must be an object, not null"}));

INSTANTIATE_TEST_SUITE_P(
    Meaning, JsonRefusal,
    testing::Values(
        Refused{"{\n \"shape\": []}", 2, 2, "Did you mean \"shapes\"?"},
        Refused{R"({"camera": {"position": [0, 0, 0]}})", 1, 12, "no \"look_at\""},
        Refused{R"({"camera": {"position": [0, 0], "look_at": [0, 0, 1]}})", 1, 25, "2 numbers"},
        Refused{R"({"camera": {"position": [0, 0, 1], "look_at": [0, 0, 1]}})", 1, 47,
                "where it stands"},
        Refused{R"({"camera": {"position": [0, 5, 0], "look_at": [0, 0, 0]}})", 1, 47, "\"up\""},
        Refused{R"({"camera": {"position": [0, 5, 0], "look_at": [0, 0, 1], "fov": "wide"}})", 1,
                65, "must be a number, not a string"},
        Refused{R"({"camera": {"position": [0, 5, 0], "look_at": [0, 0, 1], "fov": 180}})", 1, 65,
                "too wide"},
        Refused{R"({"lights": [{"type": "spot"}]})", 1, 22, "no light \"spot\""},
        Refused{R"({"lights": [{"colour": "#ffffff"}]})", 1, 13, "no \"type\""},
        Refused{R"({"lights": [{"type": "point", "position": [0, 0, 0], "color": [1, 1, 1]}]})", 1,
                54, "Did you mean \"colour\"?"},
        Refused{R"({"lights": [{"type": "directional", "direction": [0, 0, 0],
                    "colour": "#ffffff"}]})",
                1, 50, "no direction"},
        Refused{R"({"ambient_light": "#ff00f"})", 1, 19, "no colour"},
        Refused{R"({"ambient_light": [1, -1, 0]})", 1, 23, "negative"},
        Refused{R"({"materials": {"wood": {"shinyness": 3}}})", 1, 25,
                "Did you mean \"shininess\"?"},
        Refused{R"({"materials": {"wood": {"index": 0}}})", 1, 34, "greater than 0"},
        Refused{"{\"materials\": {\"wood\": {\"diffuse\":\n   {\"texture\": \"missing.png\"}}}}", 2,
                16, "the texture cannot be used: folder/missing.png: no such file. Look for it."},
        Refused{R"({"materials": {"wood": {"diffuse": {"texture": ""}}}})", 1, 48, "no name"},
        Refused{R"({"materials": {"wood": {}}, "shapes": [{"type": "box", "material": "wod"}]})", 1,
                68, "Did you mean \"wood\"?"},
        Refused{R"({"shapes": [{"type": "spere"}]})", 1, 22, "Did you mean \"sphere\"?"},
        Refused{R"({"shapes": [{"type": "sphere", "radius": -1}]})", 1, 42, "greater than 0"},
        Refused{R"({"shapes": [{"type": "sphere", "radius": 1e-200}]})", 1, 13, "too small"},
        Refused{R"({"shapes": [{"type": "cone", "capped": 1}]})", 1, 40, "true or false"},
        Refused{R"({"shapes": [{"type": "model", "file": "missing.obj"}]})", 1, 39,
                "the model cannot be used: folder/missing.obj: no such file"},
        Refused{R"({"shapes": [{"type": "model", "file": "a",
                    "fit": {"lower": [0, 0, 0], "upper": [1, 0, 1]}}]})",
                2, 28, "no room"},
        Refused{
            R"({"shapes": [{"type": "box", "transform": [{"scale": 2}, {"scale": [1, 0, 1]}]}]})",
            1, 57, "singular"},
        Refused{R"({"shapes": [{"type": "box", "transform": [{"rotate": {"axis": [0, 0, 0],
                    "degrees": 1}}]}]})",
                1, 63, "no direction"},
        Refused{
            R"({"shapes": [{"type": "box", "transform": [{"scale": 1, "translate": [1, 1, 1]}]}]})",
            1, 43, "one key"},
        Refused{R"({"shapes": [{"type": "box", "transform": [{"matrix": [[1, 0, 0, 0]]}]}]})", 1,
                54, "four rows"},
        Refused{R"({"shapes": [{"type": "box", "transform": [{"matrix":
          [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 2]]}]}]})",
                2, 54, "last row"},
        Refused{R"({"shapes": [{"type": "box", "transform": [{"matrix":
          [[1, 0, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}]}]})",
                1, 43, "singular"},
        Refused{R"({"shapes": [{"type": "box", "transform": [{"matrix":
          [[0.1, 0.2, 0.3, 0], [0.4, 0.5, 0.6, 0], [0.7, 0.8, 0.9, 0], [0, 0, 0, 1]]}]}]})",
                1, 43, "singular"},
        Refused{R"({"shapes": [{"type": "group", "children": 3}]})", 1, 43, "must be a list"},
        Refused{R"({"background": {"posx": "a"}})", 1, 16, "no \"negx\""}));

TEST(JsonRefusal, OfModelsWhereNobodyReadsThem) {
  Files files;
  files.readers.model = {};
  EXPECT_THROW(
      static_cast<void>(readText(R"({"shapes": [{"type": "model", "file": "a.obj"}]})", files)),
      Error);
}

/// The error of a scene that must be refused.
Error errorOf(std::string_view text) {
  try {
    static_cast<void>(readText(text));
  } catch (const Error& error) {
    return error;
  }
  return {ErrorCode::Cancelled, "was read", ""};
}

TEST(JsonRefusal, OfAMillionBrackets) {
  for (const std::string& bracket : {std::string("["), std::string("{\"a\":")}) {
    std::string text = "{\n\"shapes\": ";
    for (int i = 0; i < 1'000'000; ++i)
      text += bracket;
    const Error error = errorOf(text);
    EXPECT_EQ(error.code(), ErrorCode::MalformedFile);
    EXPECT_EQ(error.line(), 2);
    EXPECT_NE(std::string(error.what()).find(": the file is nested deeper than "),
              std::string::npos)
        << error.what();
    // The scene is the first level, and the first bracket stands in column 11.
    EXPECT_EQ(error.column(),
              11 + static_cast<std::int64_t>((json_format::kMaxNestingDepth - 1) * bracket.size()));
  }
}

TEST(JsonScene, GroupsMayBeNestedAsDeepAsTheLimitHas) {
  const auto nested = [](std::size_t depth) {
    std::string text = "{\"shapes\": [";
    for (std::size_t i = 0; i < depth; ++i)
      text += R"({"type": "group", "children": [)";
    text += R"({"type": "box", "transform": [{"rotate": {"axis": [0, 0, 1], "degrees": 90}}],
                "material": {"diffuse": {"texture": "wood.png", "factor": [1, 1, 1]}}})";
    for (std::size_t i = 0; i < depth; ++i)
      text += "]}";
    return text + "]}";
  };
  EXPECT_EQ(readText(nested(60)).shapes.size(), 1u);
  EXPECT_EQ(readText(nested(100)).shapes.size(), 1u);
  EXPECT_EQ(json_format::kMaxGroupDepth, 100u);
  EXPECT_THROW(static_cast<void>(readText(nested(101))), Error);
}

TEST(JsonRefusal, OfLongFilesAndManyValues) {
  const std::string line = "{\"title\": \"" + std::string(100'000'000, 'a');
  const Error tooLong = errorOf(line);
  EXPECT_EQ(tooLong.code(), ErrorCode::CapacityExceeded);
  EXPECT_EQ(tooLong.line(), 1);
  EXPECT_GT(tooLong.column(), 1'000'000);
  EXPECT_NE(std::string(tooLong.what()).find(": the file goes on beyond 67108864 bytes"),
            std::string::npos)
      << tooLong.what();
  EXPECT_LT(std::string(errorOf(line.substr(0, 1'000'000)).what()).size(), 500u);

  std::string zeros = "{\"shapes\": [0";
  for (std::size_t i = 0; i < json_format::kMaxValueCount; ++i)
    zeros += ",0";
  const Error tooMany = errorOf(zeros);
  EXPECT_EQ(tooMany.code(), ErrorCode::CapacityExceeded) << tooMany.what();
  EXPECT_NE(std::string(tooMany.what()).find(": the file has more than 4194304 values"),
            std::string::npos)
      << tooMany.what();
}

TEST(JsonScene, AnyPrefixOfAFileIsAnErrorAndNoCrash) {
  const std::string text = R"({"camera": {"position": [0, 0, 4.5e0], "look_at": [0, 0, 0]},
    "materials": {"a\u00e9": {"diffuse": "#12abEF"}}, "shapes": [{"type": "box"}, null]})";
  for (std::size_t length = 0; length < text.size(); ++length) {
    const Error error = errorOf(text.substr(0, length));
    EXPECT_EQ(error.code(), ErrorCode::MalformedFile) << length;
    EXPECT_GE(error.column(), 1) << length;
  }
}

}  // namespace
}  // namespace planetree::test
