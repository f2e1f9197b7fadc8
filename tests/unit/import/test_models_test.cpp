#include "import/import_mesh.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <vector>

namespace planetree::test {
namespace {

namespace fs = std::filesystem;

/// Where Debian's assimp-testmodels puts them.
constexpr const char* kFolder = "/usr/share/assimp/models";

std::vector<fs::path> testModels() {
  std::vector<fs::path> paths;
  std::error_code missing;
  for (const auto& entry : fs::recursive_directory_iterator(kFolder, missing)) {
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

TEST(TestModels, GltfExamplesHaveTheTrianglesThatTheyAreKnownFor) {
  const fs::path samples = fs::path(kFolder) / "glTF2";
  const fs::path engine = samples / "2CylinderEngine-glTF-Binary" / "2CylinderEngine.glb";
  if (!fs::exists(engine))
    GTEST_SKIP() << "assimp-testmodels is not installed";
  EXPECT_EQ(importing::importMesh<float>(engine).faces.size(), 121'496u);
}

}  // namespace
}  // namespace planetree::test
