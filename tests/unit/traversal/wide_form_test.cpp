#include "traversal/search_wide.hpp"

#include <planetree/planetree.hpp>

#include "compare_forms.hpp"
#include "support/build_variants.hpp"
#include "support/hard_cases.hpp"
#include "support/random.hpp"
#include "traversal/hit_choices.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace planetree::detail {
namespace {

template <class T>
class WideForm : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(WideForm, Scalars);

TYPED_TEST(WideForm, AgreesBitForBitWithTheBinaryFormOnEveryInstructionSet) {
  using T = TypeParam;
  std::uint64_t salt = 4000;
  for (const test::HardMesh<T>& hard : test::hardMeshes<T>()) {
    for (const auto& [variant, options] : test::buildVariants()) {
      SCOPED_TRACE(hard.name + ", " + variant + ", " + test::describeSeed());
      const auto tree = buildTree(hard.mesh.view(), options);
      compareForms(tree.view(), test::hardRays(hard.mesh, tree.bounds(), 200, ++salt));
      compareForms(tree.view(), test::invalidRays<T>());
      if (this->HasFailure())
        return;
    }
  }
}

/// All hits that the options accept, by one set of kernels; nothing if they leave the ray alone.
template <class T>
std::optional<std::vector<Hit<T>>> askForAll(const TreeView<T>& tree, const Ray<T>& ray,
                                             const QueryOptions& options, const Kernels& kernels) {
  std::vector<Hit<T>> hits(200);
  const HitChoices<T> choices{options, ray.direction};
  Request<T> request(tree, ray, ray.tMin, ray.tMax);
  request.mask = options.mask;
  ListSink<T> sink(choices, request.interval.tMax, hits);
  request.sink = &sink;
  Hit<T> unused;
  if (!searchWide<EveryOffer>(request, unused, kernels))
    return std::nullopt;
  hits.resize(sink.count());
  return hits;
}

TYPED_TEST(WideForm, FindsAllHitsOnEveryInstructionSet) {
  using T = TypeParam;
  test::Random random(21);
  std::vector<Sphere<T>> spheres;
  for (int i = 0; i < 60; ++i) {
    spheres.push_back(
        {random.pointIn<T>({-1, -1, -1}, {1, 1, 1}), static_cast<T>(random.between(0.02, 0.2))});
  }
  Scene<T> scene;
  scene.add(test::detail::soup<T>(22, 300, 0.3), {.mask = 1});
  scene.add(std::move(spheres), {.mask = 2});
  const auto tree = buildTree(scene);
  const HitFilter filter(
      [](const Hit<T>& hit, void*) noexcept { return (hit.primitive & 3u) != 0; });
  const std::vector<QueryOptions> choices = {
      {}, {.mask = 1}, {.cullsBackFaces = true}, {.crossings = true}, {.filter = filter}};
  for (const Ray<T>& ray : test::hardRays(TriangleMesh<T>{}, tree.bounds(), 500, 23)) {
    for (const QueryOptions& options : choices) {
      StepCounts steps;
      std::vector<Hit<T>> expected(200);
      const FoundHits found = findIntersections<T>(tree.view(), ray, expected, options, &steps);
      expected.resize(found.count);
      for (const Kernels& kernels : supportedKernels()) {
        ASSERT_EQ(askForAll(tree.view(), ray, options, kernels).value_or(expected), expected)
            << kernels.name << ", " << test::describeSeed();
      }
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
  for (const auto& [variant, options] : test::buildVariants()) {
    SCOPED_TRACE(variant);
    const auto tree = buildTree(scene, options);
    const auto rays = test::hardRays(TriangleMesh<T>{}, tree.bounds(), 700, 14);
    for (const std::uint32_t mask : {0xFFFF'FFFFu, 1u, 2u, 5u, 8u}) {
      SCOPED_TRACE(mask);
      EXPECT_GT(compareForms(tree.view(), rays, {.mask = mask}), rays.size() / 2);
    }
  }
}

TYPED_TEST(WideForm, LeavesRaysBeyondItsRangeToTheBinaryForm) {
  using T = TypeParam;
  const auto tree = buildTree(test::detail::soup<T>(15, 100, 0.3));
  for (const T scale : {T(0x1p-60), T(0x1p+60)}) {
    const Ray<T> ray{.origin = {0, 0, 3}, .direction = {0, 0, -scale}};
    const TreeView<T> view = tree.view();
    const Request<T> request(view, ray, ray.tMin, ray.tMax);
    Hit<T> hit;
    EXPECT_EQ(searchWide<NearestHit>(request, hit), std::nullopt);
    EXPECT_EQ(tree.findIntersection(ray), askBinaryForm(view, ray));
  }
}

TYPED_TEST(WideForm, AnswersAlmostAllRaysOfOrdinaryScenes) {
  using T = TypeParam;
  const auto tree = buildTree(test::detail::soup<T>(16, 500, 0.1));
  const auto rays = test::hardRays(TriangleMesh<T>{}, tree.bounds(), 500, 17);
  EXPECT_EQ(compareForms(tree.view(), rays), rays.size() * supportedKernels().size());
}

TEST(Kernels, EveryMachineHasThePlainOnes) {
  ASSERT_FALSE(supportedKernels().empty());
  EXPECT_EQ(supportedKernels().back().name, "scalar");
}

}  // namespace
}  // namespace planetree::detail
