#include <planetree/planetree.hpp>

#include "support/batch_rays.hpp"
#include "support/batch_scenes.hpp"
#include "support/build_variants.hpp"
#include "support/compare_batches.hpp"
#include "support/flush_to_zero.hpp"
#include "support/hard_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace planetree::test {
namespace {

template <class T>
class Batch : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Batch, Scalars);

template <class T>
std::vector<T> hitTs(const SingleAnswers<T>& answers) {
  std::vector<T> ts;
  for (const Hit<T>& hit : answers.hits)
    ts.push_back(hit.t);
  return ts;
}

TYPED_TEST(Batch, AgreesBitForBitWithSingleRaysOnCoherentAndRandomRaysInAnyOrder) {
  using T = TypeParam;
  std::uint64_t salt = 11'000;
  std::size_t rayCount = 0;
  std::size_t hitCount = 0;
  for (const BatchScene<T>& scene : batchScenes<T>()) {
    const TreeView<T>& tree = scene.tree.view();
    const auto random = randomRays<T>(scene.tree.bounds(), 2000, ++salt);
    for (const RaySet<T>& set : raySets(scene.mesh, scene.tree.bounds(), salt += 10)) {
      SCOPED_TRACE(scene.name + ", " + set.name + ", " + describeSeed());
      const SingleAnswers<T> alone(tree, set.rays);
      rayCount += set.rays.size();
      hitCount += alone.hitCount;
      expectAnswers<T>(tree, set.rays, alone);
      expectSameAsAlone(tree, withIntervals(set.rays, hitTs(alone), ++salt));
      expectSameAsAlone(tree, shuffled(set.rays, ++salt));
      expectSameAsAlone(tree, mixed(set.rays, random, ++salt));
      expectSameAsAlone(tree, withBadRays(set.rays, ++salt));
      if (this->HasFailure())
        return;
    }
  }
  EXPECT_GT(hitCount, rayCount / 3) << "most of these rays should meet something";
}

template <class T>
void agreesOnHardCases(bool flushesToZero) {
  const FlushToZero mode(flushesToZero);
  std::uint64_t salt = 12'000;
  for (const HardMesh<T>& hard : hardMeshes<T>()) {
    for (const auto& [variant, options] : buildVariants()) {
      SCOPED_TRACE(hard.name + ", " + variant + ", " + describeSeed());
      const KdTree<Face<T>> tree = buildTree(hard.mesh.view(), options);
      auto rays = hardRays(hard.mesh, tree.bounds(), 300, ++salt);
      const auto aimed = raysAtSharedPlaces(hard.mesh, rays.front().origin, 50);
      rays.insert(rays.end(), aimed.begin(), aimed.end());
      expectSameAsAlone(tree.view(), rays);
      expectSameAsAlone(tree.view(), withBadRays(rays, ++salt));
      if (testing::Test::HasFailure())
        return;
    }
  }
}

TYPED_TEST(Batch, AgreesBitForBitWithSingleRaysOnHardCases) {
  agreesOnHardCases<TypeParam>(false);
}

TYPED_TEST(Batch, AgreesBitForBitWithSingleRaysWhenDenormalsAreFlushed) {
  agreesOnHardCases<TypeParam>(true);
}

TYPED_TEST(Batch, OfRaysThatMissByDefinitionHitsNothing) {
  using T = TypeParam;
  for (const BatchScene<T>& scene : batchScenes<T>()) {
    const std::vector<Ray<T>> rays = invalidRays<T>();
    const SingleAnswers<T> alone(scene.tree.view(), rays);
    EXPECT_EQ(alone.hitCount, 0u);
    expectAnswers<T>(scene.tree.view(), rays, alone);
  }
}

TYPED_TEST(Batch, OfRaysBeyondTheRangeOfTheWideFormAsksTheBinaryForm) {
  using T = TypeParam;
  for (const BatchScene<T>& scene : batchScenes<T>()) {
    SCOPED_TRACE(scene.name);
    // More than a packet of each, of one kind and of all.
    std::vector<Ray<T>> rays;
    for (const Ray<T>& ray : rangelessRays<T>())
      rays.insert(rays.end(), 20, ray);
    expectSameAsAlone(scene.tree.view(), rays);
    expectSameAsAlone(scene.tree.view(), shuffled(rays, 13'000));
  }
}

/// Rejects about every other hit.
template <class T>
bool acceptsByTheLook(const Hit<T>& hit, void* /*context*/) noexcept {
  return ((hit.primitive * 7 + hit.part + hit.geometry) & 2u) != 0 || hit.u > T(0.4);
}

TYPED_TEST(Batch, HonoursTheChoicesOfItsQuery) {
  using T = TypeParam;
  const HitFilter filter(acceptsByTheLook<T>);
  std::vector<QueryOptions> choices;
  for (const std::uint32_t mask : {0u, 1u, 2u, 6u, 9u, 16u})
    choices.push_back({.mask = mask});
  choices.push_back({.cullsBackFaces = true});
  choices.push_back({.crossings = true});
  choices.push_back({.filter = filter});
  choices.push_back({.mask = 7, .cullsBackFaces = true, .crossings = true, .filter = filter});
  std::uint64_t salt = 14'000;
  for (const BatchScene<T>& scene : batchScenes<T>()) {
    const TreeView<T>& tree = scene.tree.view();
    const auto sets = raySets(scene.mesh, scene.tree.bounds(), ++salt);
    const RaySet<T>& picture = sets.front();
    auto rays = mixed(picture.rays, sets.back().rays, ++salt);
    rays.resize(std::min<std::size_t>(rays.size(), 600));
    for (const QueryOptions& query : choices) {
      SCOPED_TRACE(scene.name + ", mask " + std::to_string(query.mask) + ", " + describeSeed());
      expectSameAsAlone(tree, rays, {.query = query});
    }
    for (const Hit<T>& hit : SingleAnswers<T>(tree, rays).hits) {
      if (hit.primitive % 37 == 3)
        expectSameAsAlone(tree, rays, {.query = {.skip = {hit.geometry, hit.primitive}}});
    }
    if (this->HasFailure())
      return;
  }
}

TYPED_TEST(Batch, GivesTheSameAnswersWithAnyHint) {
  using T = TypeParam;
  const auto tree = buildTree(room<T>());
  for (const RaySet<T>& set : raySets(room<T>(), tree.bounds(), 15'000)) {
    SCOPED_TRACE(set.name + ", " + describeSeed());
    const SingleAnswers<T> alone(tree.view(), set.rays);
    for (const RayHint hint :
         {RayHint::None, RayHint::Coherent, RayHint::Incoherent, RayHint::Shadow})
      expectAnswers<T>(tree.view(), set.rays, alone, {.hint = hint});
  }
}

}  // namespace
}  // namespace planetree::test
