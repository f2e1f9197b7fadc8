#include "traversal/search_wide.hpp"

#include <planetree/planetree.hpp>

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

/// What the binary form says; it is compared with brute force elsewhere.
std::optional<Hitf> askBinaryForm(const TreeView<float>& tree, const Rayf& ray,
                                  const QueryOptions& options = {}) {
  StepCounts steps;
  return findIntersection(tree, ray, options, &steps);
}

/// Compares all instruction sets with the binary form; returns how many rays the wide form took.
std::size_t compareForms(const TreeView<float>& tree, const std::vector<Rayf>& rays,
                         const QueryOptions& options = {}) {
  std::size_t answeredCount = 0;
  for (const Rayf& ray : rays) {
    const std::optional<Hitf> expected = askBinaryForm(tree, ray, options);
    Query<float> query(tree, ray, ray.tMin, ray.tMax);
    query.mask = options.mask;
    for (const WideKernels& kernels : supportedWideKernels()) {
      Hitf hit;
      const std::optional<bool> found = searchWide<NearestHit>(query, hit, kernels);
      if (!found)
        continue;
      ++answeredCount;
      EXPECT_EQ(*found, expected.has_value()) << kernels.name;
      EXPECT_EQ(hit, expected.value_or(Hitf{})) << kernels.name;
      Hitf unused;
      EXPECT_EQ(searchWide<AnyHit>(query, unused, kernels), expected.has_value()) << kernels.name;
    }
  }
  return answeredCount;
}

TEST(WideForm, AgreesBitForBitWithTheBinaryFormOnEveryInstructionSet) {
  std::uint64_t salt = 4000;
  for (const test::HardMesh<float>& hard : test::hardMeshes<float>()) {
    for (const BuildOptions& options : buildVariants()) {
      SCOPED_TRACE(hard.name + ", " + test::describeSeed());
      const auto tree = buildTree(hard.mesh.view(), options);
      compareForms(tree.view(), test::hardRays(hard.mesh, tree.bounds(), 200, ++salt));
      compareForms(tree.view(), test::invalidRays<float>());
      if (HasFailure())
        return;
    }
  }
}

TEST(WideForm, HoldsShapesBesideBlocksOfTriangles) {
  test::Random random(11);
  std::vector<Sphere<float>> spheres;
  for (int i = 0; i < 60; ++i) {
    spheres.push_back({random.pointIn<float>({-1, -1, -1}, {1, 1, 1}),
                       static_cast<float>(random.between(0.02, 0.2))});
  }
  Scene<float> scene;
  scene.add(test::detail::soup<float>(12, 300, 0.1), {.mask = 1});
  scene.add(std::move(spheres), {.mask = 2});
  scene.add(test::detail::soup<float>(13, 300, 0.1), {.mask = 4});
  for (const BuildOptions& options : buildVariants()) {
    const auto tree = buildTree(scene, options);
    const auto rays = test::hardRays(TriangleMesh<float>{}, tree.bounds(), 700, 14);
    for (const std::uint32_t mask : {0xFFFF'FFFFu, 1u, 2u, 5u, 8u}) {
      SCOPED_TRACE(mask);
      EXPECT_GT(compareForms(tree.view(), rays, {.mask = mask}), rays.size() / 2);
    }
  }
}

TEST(WideForm, LeavesRaysBeyondItsRangeToTheBinaryForm) {
  const auto tree = buildTree(test::detail::soup<float>(15, 100, 0.3));
  for (const float scale : {0x1p-60f, 0x1p+60f}) {
    const Rayf ray{.origin = {0, 0, 3}, .direction = {0, 0, -scale}};
    const Query<float> query(tree.view(), ray, ray.tMin, ray.tMax);
    Hitf hit;
    EXPECT_EQ(searchWide<NearestHit>(query, hit), std::nullopt);
    EXPECT_EQ(tree.findIntersection(ray), askBinaryForm(tree.view(), ray));
  }
}

TEST(WideForm, AnswersAlmostAllRaysOfOrdinaryScenes) {
  const auto tree = buildTree(test::detail::soup<float>(16, 500, 0.1));
  const auto rays = test::hardRays(TriangleMesh<float>{}, tree.bounds(), 500, 17);
  EXPECT_EQ(compareForms(tree.view(), rays), rays.size() * supportedWideKernels().size());
}

TEST(WideKernels, EveryMachineHasThePlainOnes) {
  ASSERT_FALSE(supportedWideKernels().empty());
  EXPECT_EQ(supportedWideKernels().back().name, "scalar");
}

}  // namespace
}  // namespace planetree::detail
