#include <planetree/mesh/read_mesh.hpp>
#include <planetree/planetree.hpp>

#include "support/brute_force.hpp"
#include "support/hard_cases.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>

namespace planetree::test {
namespace {

/// Large real meshes live outside the repository, in a folder that the environment names.
class SceneMesh : public testing::TestWithParam<const char*> {
 protected:
  std::filesystem::path path() const {
    const char* folder = std::getenv("PLANETREE_SCENES");
    return folder ? std::filesystem::path(folder) / GetParam() : std::filesystem::path();
  }
};

TEST_P(SceneMesh, AgreesWithBruteForce) {
  if (path().empty())
    GTEST_SKIP() << "PLANETREE_SCENES is not set: name a folder with " << GetParam();
  if (!std::filesystem::exists(path()))
    GTEST_SKIP() << path() << " does not exist";
  const TriangleMesh<float> mesh = readMesh<float>(path());
  const auto tree = buildTree(mesh.view());
  std::size_t hits = 0;
  for (const Rayf& ray : hardRays(mesh, tree.bounds(), 300, 91)) {
    const auto expected = bruteForce(tree, ray);
    ASSERT_EQ(tree.findIntersection(ray), expected);
    ASSERT_EQ(tree.isOccluded(ray), expected.has_value());
    hits += expected ? 1u : 0u;
  }
  EXPECT_GT(hits, 100u);
}

INSTANTIATE_TEST_SUITE_P(Folder, SceneMesh, testing::Values("bunny.ply", "sibenik.ply"),
                         [](const auto& mesh) {
                           const std::string name = mesh.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace planetree::test
