#include "golden/expect_golden.hpp"

#include "render/camera.hpp"
#include "render/render_image.hpp"
#include "scene/build_scene.hpp"
#include "scene/read_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <string>

namespace planetree::test {
namespace {

/// A scene of data/scenes. Those in the `.ray` format cover every keyword of it.
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

class GoldenSceneOf : public testing::TestWithParam<GoldenScene> {};

TEST_P(GoldenSceneOf, TheRepositoryLooksAsBefore) {
  const std::filesystem::path path =
      std::filesystem::path(PLANETREE_SCENE_FOLDER) / GetParam().file;
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

}  // namespace
}  // namespace planetree::test
