#include "traversal/search_wide.hpp"

#include <planetree/planetree.hpp>

#include "compare_forms.hpp"
#include "support/hard_cases.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace planetree::detail {
namespace {

std::vector<BuildOptions> buildVariants() {
  BuildOptions deep;
  deep.leafSize = 1;
  deep.stopsByCost = false;
  BuildOptions leaf;
  leaf.depthLimit = 1;
  return {BuildOptions{}, BuildOptions::textbook(), deep, leaf};
}

template <class T>
class WideForm : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(WideForm, Scalars);

TYPED_TEST(WideForm, AgreesBitForBitWithTheBinaryFormOnEveryInstructionSet) {
  using T = TypeParam;
  std::uint64_t salt = 4000;
  for (const test::HardMesh<T>& hard : test::hardMeshes<T>()) {
    for (const BuildOptions& options : buildVariants()) {
      SCOPED_TRACE(hard.name + ", " + test::describeSeed());
      const auto tree = buildTree(hard.mesh.view(), options);
      compareForms(tree.view(), test::hardRays(hard.mesh, tree.bounds(), 200, ++salt));
      compareForms(tree.view(), test::invalidRays<T>());
      if (this->HasFailure())
        return;
    }
  }
}

TYPED_TEST(WideForm, HoldsShapesBesideBlocksOfTriangles) {
  using T = TypeParam;
  test::Random random(11);
  std::vector<Sphere<T>> spheres;
  for (int i = 0; i < 60; ++i) {
    spheres.push_back(
        {random.pointIn<T>({-1, -1, -1}, {1, 1, 1}), static_cast<T>(random.between(0.02, 0.2))});
  }
  Scene<T> scene;
  scene.add(test::detail::soup<T>(12, 300, 0.1), {.mask = 1});
  scene.add(std::move(spheres), {.mask = 2});
  scene.add(test::detail::soup<T>(13, 300, 0.1), {.mask = 4});
  const auto tree = buildTree(scene);
  const auto rays = test::hardRays(TriangleMesh<T>{}, tree.bounds(), 1500, 14);
  for (const std::uint32_t mask : {0xFFFF'FFFFu, 1u, 2u, 5u, 8u}) {
    SCOPED_TRACE(mask);
    EXPECT_GT(compareForms(tree.view(), rays, {.mask = mask}), rays.size() / 2);
  }
}

TYPED_TEST(WideForm, LeavesRaysBeyondItsRangeToTheBinaryForm) {
  using T = TypeParam;
  const auto tree = buildTree(test::detail::soup<T>(15, 100, 0.3));
  const TreeView<T> view = tree.view();  // to outlive the query
  for (const T scale : {T(0x1p-60), T(0x1p+60)}) {
    const Ray<T> ray{.origin = {0, 0, 3}, .direction = {0, 0, -scale}};
    const Query<T> query(view, ray, ray.tMin, ray.tMax);
    Hit<T> hit;
    EXPECT_EQ(searchWide<NearestHit>(query, hit), std::nullopt);
    EXPECT_EQ(tree.findIntersection(ray), askBinaryForm(tree.view(), ray));
  }
}

TYPED_TEST(WideForm, AnswersAlmostAllRaysOfOrdinaryScenes) {
  using T = TypeParam;
  const auto tree = buildTree(test::detail::soup<T>(16, 500, 0.1));
  const auto rays = test::hardRays(TriangleMesh<T>{}, tree.bounds(), 500, 17);
  EXPECT_EQ(compareForms(tree.view(), rays), rays.size() * supportedWideKernels().size());
}

TEST(WideKernels, EveryMachineHasThePlainOnes) {
  ASSERT_FALSE(supportedWideKernels().empty());
  EXPECT_EQ(supportedWideKernels().back().name, "scalar");
}

}  // namespace
}  // namespace planetree::detail
