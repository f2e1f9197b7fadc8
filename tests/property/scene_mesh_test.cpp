#include <planetree/mesh/read_mesh.hpp>
#include <planetree/planetree.hpp>

#include "support/batch_rays.hpp"
#include "support/brute_force.hpp"
#include "support/compare_batches.hpp"
#include "support/hard_cases.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>

namespace planetree::test {
namespace {

/// Large real meshes live outside the repository, in a folder that the environment names.
class SceneMesh : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (path().empty())
      GTEST_SKIP() << "PLANETREE_SCENES is not set: name a folder with " << GetParam();
    if (!std::filesystem::exists(path()))
      GTEST_SKIP() << path() << " does not exist";
  }

  std::filesystem::path path() const {
    const char* folder = std::getenv("PLANETREE_SCENES");
    return folder ? std::filesystem::path(folder) / GetParam() : std::filesystem::path();
  }
};

TEST_P(SceneMesh, AgreesWithBruteForce) {
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

/// The name of a mesh without that of its format.
std::string nameOf(const testing::TestParamInfo<const char*>& mesh) {
  const std::string name = mesh.param;
  return name.substr(0, name.find('.'));
}

INSTANTIATE_TEST_SUITE_P(Folder, SceneMesh, testing::Values("bunny.ply", "sibenik.ply"), nameOf);

class BatchInSceneMesh : public SceneMesh {
 protected:
  template <class T>
  void agreesWithSingleRays() const {
    const TriangleMesh<T> mesh = readMesh<T>(path());
    const auto tree = buildTree(mesh.view());
    std::uint64_t salt = 92;
    for (const RaySet<T>& set : raySets(mesh, tree.bounds(), salt)) {
      SCOPED_TRACE(set.name + ", " + describeSeed());
      expectSameAsAlone(tree.view(), set.rays);
      expectSameAsAlone(tree.view(), shuffled(set.rays, ++salt));
    }
    // Triangles larger than pixels, and smaller ones.
    const auto middle =
        static_cast<Vec3<T>>((Vec3d(tree.bounds().lower) + Vec3d(tree.bounds().upper)) * 0.5);
    const PictureFrame<T> frame{{1, T(-0.1), T(0.2)}, {0, 0, T(0.8)}, {0, T(0.6), 0}};
    expectSameAsAlone(tree.view(), pinholePicture(middle, frame, 320, 240));
    expectSameAsAlone(tree.view(), panorama(middle, 100, 50));
  }
};

TEST_P(BatchInSceneMesh, AgreesBitForBitWithSingleRaysInFloat) {
  agreesWithSingleRays<float>();
}
TEST_P(BatchInSceneMesh, AgreesBitForBitWithSingleRaysInDouble) {
  agreesWithSingleRays<double>();
}

INSTANTIATE_TEST_SUITE_P(Folder, BatchInSceneMesh, testing::Values("bunny.ply", "sponza.ply"),
                         nameOf);

}  // namespace
}  // namespace planetree::test
