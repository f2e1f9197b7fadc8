#include "scene/json_format/object_syntax.hpp"
#include "scene/read_scene.hpp"

#include <planetree/error.hpp>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace planetree::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const fs::path kRepository = PLANETREE_REPOSITORY;

std::string contentOf(const fs::path& path) {
  std::ifstream file(path);
  if (!file)
    throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), {}};
}

json schema() {
  return json::parse(contentOf(kRepository / "data/scenes/scene.schema.json"));
}

/// The JSON blocks of the page about scene files.
std::vector<std::string> examplesOfThePage() {
  const std::string page = contentOf(kRepository / "docs/scene_files.md");
  std::vector<std::string> blocks;
  const std::string begin = "```json\n";
  for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
    const std::size_t first = at + begin.size();
    blocks.push_back(page.substr(first, page.find("```", first) - first));
  }
  return blocks;
}

/// All scenes of the repository.
std::vector<fs::path> sceneFiles() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kRepository / "data/scenes")) {
    if (entry.path().extension() == ".json" &&
        !entry.path().filename().string().ends_with(".schema.json"))
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// As much of JSON Schema as our schema uses. A keyword that it does not know is an error, so that
/// nothing in the schema goes unchecked.
class Validator {
 public:
  explicit Validator(json schema) : schema_(std::move(schema)) {}

  [[nodiscard]] bool accepts(const json& value) const { return accepts(value, schema_); }

 private:
  [[nodiscard]] bool accepts(const json& value, const json& schema) const {
    return std::ranges::all_of(schema.items(), [&](const auto& keyword) {
      return accepts(value, schema, keyword.key(), keyword.value());
    });
  }

  [[nodiscard]] bool accepts(const json& value, const json& schema, const std::string& keyword,
                             const json& operand) const {
    static const std::set<std::string> silent = {"$schema", "$defs", "title", "description",
                                                 "default"};
    if (silent.contains(keyword))
      return true;
    if (keyword == "$ref")
      return accepts(value, schema_.at("$defs").at(operand.get<std::string>().substr(8)));
    if (keyword == "oneOf") {
      return std::ranges::count_if(operand, [&](const json& one) { return accepts(value, one); }) ==
             1;
    }
    if (keyword == "type")
      return typeOf(value) == operand;
    if (keyword == "const")
      return value == operand;
    if (keyword == "not")
      return !accepts(value, operand);
    if (value.is_object())
      return acceptsObject(value, schema, keyword, operand);
    if (value.is_array())
      return acceptsArray(value, keyword, operand);
    if (value.is_number()) {
      const double number = value.get<double>();
      return (keyword != "minimum" || number >= operand) &&
             (keyword != "maximum" || number <= operand) &&
             (keyword != "exclusiveMinimum" || number > operand);
    }
    if (value.is_string()) {
      const auto text = value.get<std::string>();
      return (keyword != "pattern" ||
              std::regex_search(text, std::regex(operand.get<std::string>()))) &&
             (keyword != "minLength" || text.size() >= operand);
    }
    return true;
  }

  [[nodiscard]] bool acceptsObject(const json& value, const json& schema,
                                   const std::string& keyword, const json& operand) const {
    if (keyword == "properties") {
      return std::ranges::all_of(operand.items(), [&](const auto& property) {
        return !value.contains(property.key()) ||
               accepts(value.at(property.key()), property.value());
      });
    }
    if (keyword == "required") {
      return std::ranges::all_of(
          operand, [&](const json& key) { return value.contains(key.get<std::string>()); });
    }
    if (keyword == "additionalProperties") {
      return std::ranges::all_of(value.items(), [&](const auto& member) {
        return schema.value("properties", json::object()).contains(member.key()) ||
               (operand.is_object() && accepts(member.value(), operand));
      });
    }
    if (keyword == "minProperties")
      return value.size() >= operand;
    if (keyword == "maxProperties")
      return value.size() <= operand;
    return isOfOtherTypes(keyword);
  }

  [[nodiscard]] bool acceptsArray(const json& value, const std::string& keyword,
                                  const json& operand) const {
    if (keyword == "items")
      return std::ranges::all_of(value, [&](const json& item) { return accepts(item, operand); });
    if (keyword == "minItems")
      return value.size() >= operand;
    if (keyword == "maxItems")
      return value.size() <= operand;
    return isOfOtherTypes(keyword);
  }

  static bool isOfOtherTypes(const std::string& keyword) {
    static const std::set<std::string> known = {
        "properties",      "required",      "additionalProperties",
        "minProperties",   "maxProperties", "items",
        "minItems",        "maxItems",      "minimum",
        "maximum",         "pattern",       "minLength",
        "exclusiveMinimum"};
    if (!known.contains(keyword))
      throw std::logic_error("the validator does not know " + keyword);
    return true;
  }

  static std::string typeOf(const json& value) {
    return value.is_number() ? "number" : value.is_boolean() ? "boolean" : value.type_name();
  }

  json schema_;
};

TEST(SceneSchema, HasTheKeysOfTheReader) {
  const json definitions = schema().at("$defs");
  for (const scene::json_format::ObjectSyntax* syntax : scene::json_format::objectSyntaxes()) {
    const json& definition = definitions.at(std::string(syntax->name));
    std::set<std::string> known(syntax->required.begin(), syntax->required.end());
    const std::set<std::string> required = known;
    known.insert(syntax->optional.begin(), syntax->optional.end());
    std::set<std::string> documented;
    for (const auto& property : definition.at("properties").items())
      documented.insert(property.key());
    EXPECT_EQ(documented, known) << syntax->name;
    EXPECT_EQ(definition.value("required", std::set<std::string>()), required) << syntax->name;
    EXPECT_EQ(definition.at("additionalProperties"), false) << syntax->name;
  }
}

TEST(SceneSchema, ThePageHasAllKeys) {
  const std::string page = contentOf(kRepository / "docs/scene_files.md");
  for (const scene::json_format::ObjectSyntax* syntax : scene::json_format::objectSyntaxes()) {
    for (const auto& keys : {syntax->required, syntax->optional}) {
      for (const std::string_view key : keys) {
        const auto isThereBetween = [&](const char* quote) {
          return page.find(std::string(quote).append(key).append(quote)) != std::string::npos;
        };
        EXPECT_TRUE(isThereBetween("`") || isThereBetween("\"")) << key;
      }
    }
  }
}

TEST(SceneSchema, AcceptsTheExamples) {
  const Validator validator(schema());
  ASSERT_GE(sceneFiles().size(), 3u);
  for (const fs::path& path : sceneFiles())
    EXPECT_TRUE(validator.accepts(json::parse(contentOf(path)))) << path;
  ASSERT_FALSE(examplesOfThePage().empty());
  for (const std::string& example : examplesOfThePage())
    EXPECT_TRUE(validator.accepts(json::parse(example))) << example;
}

TEST(SceneSchema, RefusesWhatIsWrong) {
  const Validator validator(schema());
  EXPECT_TRUE(validator.accepts(json::parse("{}")));
  for (const char* wrong :
       {R"([])", R"({"shape": []})", R"({"shapes": [{"type": "spere"}]})",
        R"({"shapes": [{"type": "sphere", "radius": 0}]})", R"({"ambient_light": [1, 1]})",
        R"({"ambient_light": "#12345"})", R"({"ambient_light": [1, -1, 1]})",
        R"({"camera": {"position": [0, 0, 0]}})",
        R"({"lights": [{"type": "point", "direction": [1, 0, 0], "colour": [1, 1, 1]}]})",
        R"({"shapes": [{"type": "box", "transform": [{"scale": 1, "translate": [1, 1, 1]}]}]})",
        R"({"shapes": [{"type": "model"}]})", R"({"materials": {"a": {"shiny": 1}}})"})
    EXPECT_FALSE(validator.accepts(json::parse(wrong))) << wrong;
}

/// Models and textures are not what these tests are about.
scene::SceneFileReaders fileReaders() {
  return {.model =
              [](const fs::path& path) {
                EXPECT_TRUE(fs::exists(path)) << path;
                return scene::SceneDescription();
              },
          .texture =
              [](const fs::path& path) {
                EXPECT_TRUE(fs::exists(path)) << path;
                return scene::Texture(1, 1, std::vector<Vec3f>(1));
              }};
}

/// A scene with every key there is.
json wholeScene() {
  return json::parse(R"({
    "$schema": "scene.schema.json", "title": "All", "ambient_light": "#102030",
    "camera": {"position": [1, 2, 6], "look_at": [3, 4, 5], "up": [1, 2, 1], "fov": 35,
               "aspect_ratio": 1.5},
    "lights": [{"type": "point", "position": [2, 4, 3], "colour": [1, 1, 1], "constant": 1,
                "linear": 1, "quadratic": 1},
               {"type": "directional", "direction": [1, 1, 1], "colour": "#ffffff"}],
    "materials": {
      "plain": {"emissive": [1, 1, 1], "ambient": [1, 1, 1], "diffuse": [1, 1, 1],
                "specular": [1, 1, 1], "reflective": [1, 1, 1], "transmissive": [1, 1, 1],
                "index": 1.5, "shininess": 3},
      "images": {"diffuse": {"texture": "a.png", "factor": [1, 1, 1]},
                 "index": {"texture": "a.png", "factor": 1.5},
                 "shininess": {"texture": "a.png", "factor": 3}}},
    "background": {"posx": "a", "negx": "a", "posy": "a", "negy": "a", "posz": "a", "negz": "a"},
    "shapes": [
      {"type": "sphere", "radius": 2, "name": "a", "material": {"diffuse": [1, 0, 0]},
       "position": [1, 2, 3],
       "transform": [{"translate": [1, 2, 3]}, {"rotate": {"axis": [1, 1, 1], "degrees": 30}},
                     {"scale": 2}, {"scale": [1, 2, 3]},
                     {"matrix": [[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]]}]},
      {"type": "box", "size": 2}, {"type": "box", "size": [1, 2, 3]}, {"type": "square", "size": 2},
      {"type": "cylinder", "radius": 2, "height": 3, "capped": false},
      {"type": "cone", "bottom_radius": 2, "top_radius": 1, "height": 2, "capped": true},
      {"type": "model", "file": "a", "fit": {"lower": [-9, -9, -9], "upper": [9, 9, 9]}},
      {"type": "group", "children": [{"type": "box"}]}
    ]})");
}

bool isRead(const json& scene) {
  const scene::SceneFileReaders readers = {
      .model = [](const fs::path&) { return scene::SceneDescription(); },
      .texture = [](const fs::path&) { return scene::Texture(1, 1, std::vector<Vec3f>(1)); }};
  const std::string text = scene.dump();
  try {
    static_cast<void>(
        scene::readJsonScene(std::as_bytes(std::span(text)), "test.json", "", readers));
  } catch (const Error&) {
    return false;
  }
  return true;
}

/// What depends on more than one value, which no schema can say: names of materials that are there,
/// matrices that press nothing flat, boxes with room in them.
bool isBeyondSchemas(const std::string& path, const json& value) {
  static const std::regex names(".*/material");
  static const std::regex relations(".*/(matrix|lower|upper)(/.*)?");
  return (value.is_string() && std::regex_match(path, names)) ||
         ((value.is_number() || value.is_array()) && std::regex_match(path, relations));
}

TEST(SceneSchema, TakesAndRefusesTheValuesThatTheReaderDoes) {
  const Validator validator(schema());
  const json whole = wholeScene();
  ASSERT_TRUE(validator.accepts(whole));
  ASSERT_TRUE(isRead(whole));
  const json values = json::parse(R"([null, true, -1, 0, 0.5, 179, 180, "", "x", "#12345g", [], {},
      [1], [1, 1, 1], [1, 0, 1], [1, -1, 1], [0.5, 2, 1e3], [1, 1, 1, 1], ["1", "1", "1"]])");
  // Of each value itself, and of the lists and objects around it.
  const json leaves = whole.flatten();
  std::set<std::string> paths;
  for (const auto& leaf : leaves.items()) {
    for (json::json_pointer at(leaf.key()); !at.empty(); at.pop_back())
      paths.insert(at.to_string());
  }
  for (const std::string& path : paths) {
    for (const json& value : values) {
      if (isBeyondSchemas(path, value))
        continue;
      json changed = whole;
      changed[json::json_pointer(path)] = value;
      EXPECT_EQ(validator.accepts(changed), isRead(changed))
          << path << " = " << value << (isRead(changed) ? " is read" : " is refused");
    }
  }
}

/// All keys that stand for something where they are left out have a default, and those of the
/// camera make no difference.
TEST(SceneSchema, HasTheDefaultsOfTheReader) {
  const json definitions = schema().at("$defs");
  const std::set<std::string> withoutDefault = {
      "$schema", "title",     "camera",   "ambient_light", "lights",     "materials",
      "shapes",  "name",      "material", "transform",     "background", "fit",
      "ambient", "translate", "rotate",   "scale",         "matrix"};
  for (const scene::json_format::ObjectSyntax* syntax : scene::json_format::objectSyntaxes()) {
    const json& properties = definitions.at(std::string(syntax->name)).at("properties");
    for (const std::string_view key : syntax->optional) {
      const json& property = properties.at(std::string(key));
      ASSERT_NE(property.contains("default"), withoutDefault.contains(std::string(key)))
          << syntax->name << ", " << key;
    }
  }

  const auto view = [&](bool isExplicit) {
    json camera = json::parse(R"({"position": [0, 1, 5], "look_at": [0, 0, 0]})");
    if (isExplicit) {
      for (const char* key : {"up", "fov", "aspect_ratio"})
        camera[key] = definitions.at("camera").at("properties").at(key).at("default");
    }
    const std::string text = json{{"camera", camera}}.dump();
    return *scene::readJsonScene(std::as_bytes(std::span(text)), "a", "", fileReaders()).view;
  };
  EXPECT_EQ(view(true).u, view(false).u);
  EXPECT_EQ(view(true).v, view(false).v);
}

TEST(SceneExamples, AreRead) {
  for (const fs::path& path : sceneFiles()) {
    const scene::SceneDescription scene = readJsonScene(path, fileReaders());
    EXPECT_EQ(scene.name, path.filename().string());
    EXPECT_TRUE(scene.view) << path;
    EXPECT_FALSE(scene.shapes.empty()) << path;
    EXPECT_GT(scene.pointLights.size() + scene.directionalLights.size(), 0u) << path;
  }
}

TEST(SceneExamples, OfThePageIsRead) {
  for (const std::string& example : examplesOfThePage()) {
    const auto scene =
        scene::readJsonScene(std::as_bytes(std::span(example)), "page", "", fileReaders());
    EXPECT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(scene.shapes[0].name, "marble");
  }
}

}  // namespace
}  // namespace planetree::test
