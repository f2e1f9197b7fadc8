#include "import/import_mesh.hpp"
#include "import/import_scene.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace planetree::test {
namespace {

namespace fs = std::filesystem;

/// Where Debian's assimp-testmodels puts them.
const std::string kFolder = "/usr/share/assimp/models";

std::vector<fs::path> testModels(const std::string& part = "") {
  std::vector<fs::path> paths;
  std::error_code missing;
  for (const auto& entry : fs::recursive_directory_iterator(kFolder + part, missing)) {
    if (entry.is_regular_file())
      paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(TestModels, AreReadOrRefusedInOneLine) {
  const std::vector<fs::path> paths = testModels();
  if (paths.empty())
    GTEST_SKIP() << "assimp-testmodels is not installed";
  std::size_t readCount = 0;
  for (const fs::path& path : paths) {
    try {
      const TriangleMesh<float> mesh = importing::importMesh<float>(path);
      EXPECT_TRUE(mesh.sourceFaces.empty() || mesh.sourceFaces.size() == mesh.faces.size());
      readCount += mesh.faces.empty() ? 0u : 1u;
    } catch (const Error& error) {
      EXPECT_EQ(error.file(), path.string());
      EXPECT_FALSE(error.advice().empty()) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
  std::cout << readCount << " of " << paths.size() << " files have triangles\n";
  // Textures, buffers and texts are among the files.
  EXPECT_GT(readCount, paths.size() / 2);
}

TEST(TestModels, WithTexturesAreScenesOrRefusedInOneLine) {
  std::vector<fs::path> paths;
  for (const char* const part : {"/glTF2", "/OBJ", "/Collada"}) {
    const std::vector<fs::path> some = testModels(part);
    paths.insert(paths.end(), some.begin(), some.end());
  }
  if (paths.empty())
    GTEST_SKIP() << "assimp-testmodels is not installed";
  std::size_t readCount = 0;
  std::size_t textureCount = 0;
  for (const fs::path& path : paths) {
    try {
      const scene::SceneDescription scene = importing::importScene(path);
      readCount += scene.shapes.empty() ? 0u : 1u;
      textureCount += scene.textures.size();
      for (const scene::PlacedShape& shape : scene.shapes)
        ASSERT_LT(shape.material, scene.materials.size()) << path;
      EXPECT_FALSE(scene.pointLights.empty() && scene.directionalLights.empty() &&
                   scene.ambientLight == Vec3d{})
          << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.file(), path.string());
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
  std::cout << readCount << " of " << paths.size() << " files are scenes, with " << textureCount
            << " textures\n";
  EXPECT_GT(readCount, paths.size() / 3);
  EXPECT_GE(textureCount, 20u);
}

TEST(TestModels, GltfExamplesHaveTheTrianglesThatTheyAreKnownFor) {
  const fs::path samples = fs::path(kFolder) / "glTF2";
  const fs::path engine = samples / "2CylinderEngine-glTF-Binary" / "2CylinderEngine.glb";
  if (!fs::exists(engine))
    GTEST_SKIP() << "assimp-testmodels is not installed";
  EXPECT_EQ(importing::importMesh<float>(engine).faces.size(), 121'496u);
}

}  // namespace
}  // namespace planetree::test
