#include "golden/expect_golden.hpp"

#include "render/camera.hpp"
#include "render/render_image.hpp"
#include "scene/build_scene.hpp"
#include "scene/ray_format/keywords.hpp"
#include "scene/ray_format/lexer.hpp"
#include "scene/read_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planetree::test {
namespace {

namespace ray_format = scene::ray_format;

/// A scene of data/scenes.
struct GoldenScene {
  std::string file;
};

const GoldenScene kScenes[] = {
    {"attenuation.ray"}, {"coloured_shadows.ray"}, {"forest.ray"},
    {"sea.ray"},         {"spheres.ray"},          {"textures.ray"},
    {"transforms.ray"},  {"forest.json"},          {"glass_and_mirrors.json"}};

void PrintTo(const GoldenScene& scene, std::ostream* out) {
  *out << scene.file;
}

std::filesystem::path pathOf(const GoldenScene& scene) {
  return std::filesystem::path(PLANETREE_SCENE_FOLDER) / scene.file;
}

class GoldenSceneOf : public testing::TestWithParam<GoldenScene> {};

TEST_P(GoldenSceneOf, TheRepositoryLooksAsBefore) {
  const std::filesystem::path path = pathOf(GetParam());
  scene::SceneDescription description =
      path.extension() == ".ray" ? scene::readRayScene(path) : scene::readJsonScene(path, {});
  ASSERT_TRUE(description.view);
  constexpr std::uint32_t kWidth = 180;
  const render::ImageSize size{
      kWidth, static_cast<std::uint32_t>(std::lround(kWidth / description.view->aspectRatio()))};
  const scene::BuiltScene built(std::move(description));
  const render::TreeTracer<AnyObject<float>> tracer(built.tree());
  render::RenderSettings settings;
  settings.size = size;
  settings.view = built.description().view;
  settings.mode = render::RenderMode::Whitted;
  settings.grid = {.side = 3, .threshold = 0.05f};
  settings.scene = &built;
  const render::Rendering rendering = renderImage(tracer, settings);
  // Other compilers round the shading differently, and a ray at an outline may see another shape.
  constexpr double kTolerance = 2.0;
  std::string name = GetParam().file;
  std::ranges::replace_if(
      name, [](char c) { return c == '.' || c == '_'; }, '-');
  expectGolden(shownImage(rendering), "scene-" + name, kTolerance);
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenSceneOf, testing::ValuesIn(kScenes), [](const auto& suite) {
  std::string name = suite.param.file;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

/// What stands in `.ray` scenes: their words, as "sphere"; those in a block, as "sphere.name"; and
/// words that are the value of another one, as "ambient = map".
class UsedWords {
 public:
  void addScene(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    ASSERT_TRUE(file) << path;
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const std::string name = path.string();
    ray_format::Lexer lexer(std::as_bytes(std::span(text)), name);
    std::vector<std::string_view> blocks = {""};  // a group is one without a name
    std::string_view before;                      // the word before this token or before its "="
    for (ray_format::Token token = lexer.next(); token.kind != ray_format::TokenKind::End;
         token = lexer.next()) {
      if (token.is('{'))
        blocks.push_back(blockBehind(before, blocks.back()));
      else if (token.is('}'))
        blocks.pop_back();
      else if (token.kind == ray_format::TokenKind::Word)
        addWord(blocks.back(), before, token.text);
      if (token.kind == ray_format::TokenKind::Word)
        before = token.text;
      else if (!token.is('='))
        before = "";
    }
  }

  [[nodiscard]] bool has(const std::string& word) const { return words_.contains(word); }

 private:
  static bool isMesh(std::string_view block) { return block == "trimesh" || block == "polymesh"; }

  static std::string_view blockBehind(std::string_view word, std::string_view outer) {
    // In a mesh's list of materials, blocks stand without a keyword.
    return isMesh(outer) ? "material" : word;
  }

  void addWord(std::string_view block, std::string_view before, std::string_view word) {
    words_.emplace(word);
    words_.insert(std::string(before).append(" = ").append(word));
    words_.insert(std::string(block).append(".").append(word));
    if (isMesh(block)) {  // two words for the same
      words_.insert(std::string("trimesh.").append(word));
      words_.insert(std::string("polymesh.").append(word));
    }
  }

  std::set<std::string> words_;
};

UsedWords wordsOfGoldenScenes() {
  UsedWords used;
  for (const GoldenScene& scene : kScenes) {
    if (pathOf(scene).extension() == ".ray")
      used.addScene(pathOf(scene));
  }
  return used;
}

// What no golden picture shows may go wrong unseen.
TEST(GoldenScenes, UseEveryKeywordOfTheRayFormat) {
  const UsedWords used = wordsOfGoldenScenes();
  const auto expectUsed = [&](std::string_view word) {
    EXPECT_TRUE(used.has(std::string(word))) << "in no scene that has a golden picture: " << word;
  };
  for (const ray_format::BlockSyntax& block : ray_format::kBlocks) {
    expectUsed(block.name);
    for (const std::string_view keyword : block.keywords)
      expectUsed(std::string(block.name).append(".").append(keyword));
  }
  for (const std::string_view keyword : ray_format::kMaterialKeywords) {
    if (keyword != "name")
      expectUsed(std::string(keyword).append(" = ").append(ray_format::kMap));
  }
  for (const std::string_view word : ray_format::kTransformKeywords)
    expectUsed(word);
  for (const std::string_view word : ray_format::kValueWords)
    expectUsed(word);
  for (const auto& [usual, other] : ray_format::kOtherSpellings)
    expectUsed(other);
}

}  // namespace
}  // namespace planetree::test
