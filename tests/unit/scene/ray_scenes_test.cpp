#include "unit/scene/ray_text.hpp"

#include "scene/ray_format/keywords.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

// The scenes of the repository, and the example in the documentation.
namespace planetree::test {
namespace {

std::string textOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::filesystem::path> scenePaths() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(kSceneFolder)) {
    if (entry.path().extension() == ".ray")
      paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(RayScenes, AreReadWithoutRemarks) {
  EXPECT_GE(scenePaths().size(), 7u);
  for (const std::filesystem::path& path : scenePaths()) {
    const auto scene = scene::readRayScene(path);
    EXPECT_EQ(scene.remarks, std::vector<std::string>()) << path;
    EXPECT_FALSE(scene.shapes.empty()) << path;
    EXPECT_FALSE(scene.pointLights.empty() && scene.directionalLights.empty()) << path;
    EXPECT_EQ(scene.name, path.filename().string());
    EXPECT_LT(std::filesystem::file_size(path), 50'000u) << path;
    EXPECT_EQ(textOf(path).find('\t'), std::string::npos) << path;
  }
}

TEST(RayScenes, KeywordsAreInTheDocumentation) {
  using namespace scene::ray_format;
  const std::string page =
      textOf(std::filesystem::path(PLANETREE_REPOSITORY) / "docs/ray_format.md");
  const auto expectExplained = [&](std::string_view word) {
    const std::string code = std::string("`").append(word);
    const bool isThere = std::ranges::any_of(std::array{"`", " ", "("}, [&](const char* behind) {
      return page.find(code + behind) != std::string::npos;
    });
    EXPECT_TRUE(isThere) << word;
  };
  for (const BlockSyntax& block : kBlocks) {
    expectExplained(block.name);
    std::ranges::for_each(block.keywords, expectExplained);
  }
  std::ranges::for_each(kTransformKeywords, expectExplained);
  std::ranges::for_each(kValueWords, expectExplained);
  for (const auto& [usual, other] : kOtherSpellings)
    expectExplained(other);
}

TEST(RayScenes, OfTheDocumentationIsRead) {
  const std::string page =
      textOf(std::filesystem::path(PLANETREE_REPOSITORY) / "docs/ray_format.md");
  const std::string fence = "```ray\n";
  const std::size_t begin = page.find(fence);
  ASSERT_NE(begin, std::string::npos);
  const std::size_t first = begin + fence.size();
  const auto scene = readText(page.substr(first, page.find("```", first) - first));
  EXPECT_TRUE(scene.remarks.empty());
  ASSERT_EQ(scene.shapes.size(), 2u);
  EXPECT_EQ(scene.materials.at(scene.shapes[0].material).diffuse.value, (Vec3d{0.8, 0.15, 0.1}));
  EXPECT_EQ(scene.materials.at(scene.shapes[0].material).shininess.value, 40.0);
  EXPECT_EQ(scene.pointLights.at(0).constant, 0.25);
}

TEST(RayScenes, ErrorOfTheDocumentationIsTheOneThatIsTold) {
  const std::string page =
      textOf(std::filesystem::path(PLANETREE_REPOSITORY) / "docs/ray_format.md");
  const std::string scene =
      "SBT-raytracer 1.0\n\npoint_light {\n  positon = (0, 1, 0);\n  color = (1, 1, 1);\n}\n";
  try {
    static_cast<void>(scene::readRayScene(std::as_bytes(std::span(scene)), "lamp.ray", ""));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(page.find(error.what()), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace planetree::test
