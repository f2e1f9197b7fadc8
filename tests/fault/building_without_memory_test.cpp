#include "fault_scenes.hpp"
#include "try_faults.hpp"

#include <planetree/node/validate_tree.hpp>
#include <planetree/planetree.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace planetree::test {
namespace {

template <class T>
class BuildingWithoutMemory : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BuildingWithoutMemory, Scalars);

constexpr std::uint64_t kAll = 100'000;

std::string nameOf(const Preset& preset, std::uint32_t threadCount) {
  return std::string(preset.name) + ", " + std::to_string(threadCount) + " threads";
}

TYPED_TEST(BuildingWithoutMemory, IsToldForSmallMeshes) {
  const TriangleMesh<TypeParam> mesh = smallMesh<TypeParam>();
  for (const Preset& preset : kPresets) {
    for (const std::uint32_t threadCount : {1u, 2u}) {
      BuildOptions options = preset.options;
      options.threadCount = threadCount;
      // Costs of faces that make few of them worth a split.
      options.cost.faceCost = 1.0;
      tryFaults(
          nameOf(preset, threadCount), [&] { return buildTree(mesh.view(), options); }, kAll, 20);
    }
  }
}

TYPED_TEST(BuildingWithoutMemory, IsToldForLargeMeshes) {
  constexpr std::uint64_t kMost = 10;
  constexpr std::uint64_t kChecks = 2;
  const TriangleMesh<TypeParam> mesh = largeMesh<TypeParam>();
  for (const Preset& preset : kPresets) {
    for (const std::uint32_t threadCount : {1u, 2u}) {
      // What the scalar changes is done by one thread in any case.
      if (!triesEveryFault() && threadCount == (std::is_same_v<TypeParam, float> ? 1u : 2u))
        continue;
      BuildOptions options = preset.options;
      options.threadCount = threadCount;
      tryFaults(
          nameOf(preset, threadCount), [&] { return buildTree(mesh.view(), options); }, kMost,
          kChecks);
    }
  }
}

TYPED_TEST(BuildingWithoutMemory, IsToldForMeshesThatTheTreeOwns) {
  const TriangleMesh<TypeParam> mesh = smallMesh<TypeParam>();
  tryFaults("a copy", [&] { return buildTree(mesh); });
}

TYPED_TEST(BuildingWithoutMemory, IsToldForScenesAndShapes) {
  using T = TypeParam;
  const TriangleMesh<T> mesh = smallMesh<T>();
  for (const std::uint32_t threadCount : {1u, 2u}) {
    const BuildOptions options = {.threadCount = threadCount};
    tryFaults(
        "a scene", [&] { return buildTree(mixedScene(mesh), options); }, 200);
    std::vector<std::variant<Sphere<T>, Box<T>>> shapes;
    for (int i = 0; i < 30; ++i) {
      const T x = T(i) / T(30);
      shapes.push_back(Sphere<T>{.center = {x, 0, 0}, .radius = T(0.05)});
      shapes.push_back(Box<T>{{x, 0, 0}, {x + T(0.1), T(0.2), T(0.3)}});
    }
    tryFaults("shapes", [&] { return buildTree(shapes, options); });
    tryFaults("nothing", [&] { return buildTree(std::vector<Sphere<T>>(), options); });
  }
  tryFaults("a tree without a build", [] { return KdTree<Sphere<T>>(); });
}

TYPED_TEST(BuildingWithoutMemory, IsToldBesideOtherErrors) {
  const TriangleMesh<TypeParam> mesh = smallMesh<TypeParam>();
  const auto refusal = [&](const BuildOptions& options, const BuildControl& control) {
    try {
      return bitsOf(buildTree(mesh.view(), options, control));
    } catch (const Error& error) {
      return std::string(error.what());
    }
  };
  tryFaults("an option", [&] { return refusal({.depthLimit = 0}, {}); });
  tryFaults("a limit", [&] { return refusal({}, {.memoryLimit = 1000}); });
}

TYPED_TEST(BuildingWithoutMemory, IsToldByWhatLooksAtTrees) {
  using T = TypeParam;
  const TriangleMesh<T> mesh = smallMesh<T>();
  const auto tree = buildTree(mesh.view());
  const auto rays = someRays<T>(20);
  tryFaults("statistics", [&] { return std::to_string(tree.statistics().sahCost); });
  tryFaults("validateTree", [&] {
    return validateTree(tree.nodes(), tree.view().references, tree.bounds(), tree.objectCount())
        .value_or("sound");
  });
  tryFaults("explain", [&] {
    std::string text;
    for (const Ray<T>& ray : rays) {
      text += std::to_string(tree.explainIntersection(ray).steps.size()) + ' ';
      text += std::to_string(tree.explainOcclusion(ray).steps.size()) + ' ';
    }
    return text;
  });
}

TYPED_TEST(BuildingWithoutMemory, IsToldByBatches) {
  using T = TypeParam;
  const TriangleMesh<T> mesh = smallMesh<T>();
  const auto tree = buildTree(mesh.view());
  const auto rays = someRays<T>(6000);
  for (const std::uint32_t threadCount : {1u, 2u}) {
    for (const std::uint32_t mask : {0xFFFF'FFFFu, 1u}) {
      const BatchOptions options = {.query = {.mask = mask}, .threadCount = threadCount};
      tryFaults("nearest", [&] {
        std::vector<Hit<T>> hits(rays.size());
        tree.findIntersections(std::span<const Ray<T>>(rays), hits, options);
        return hits;
      });
      tryFaults("any", [&] {
        std::vector<std::uint8_t> flags(rays.size());
        tree.areOccluded(std::span<const Ray<T>>(rays), flags, options);
        return flags;
      });
    }
  }
  tryFaults("spans that do not match", [&] {
    try {
      std::vector<Hit<T>> hits(3);
      tree.findIntersections(std::span<const Ray<T>>(rays), hits);
      return std::string();
    } catch (const Error& error) {
      return std::string(error.what());
    }
  });
}

/// All queries of single rays, for all of the rays.
template <class O, class T>
void askAll(const KdTree<O>& tree, std::span<const Ray<T>> rays, const QueryOptions& options,
            std::span<Hit<T>> hits, std::uint64_t& hitCount) {
  StepCounts steps;
  for (const Ray<T>& ray : rays) {
    const auto nearest = tree.findIntersection(ray, options);
    hitCount += nearest.has_value() ? 1u : 0u;
    hitCount += tree.findIntersection(ray, steps, options).has_value() ? 1u : 0u;
    hitCount += tree.isOccluded(ray, options) ? 1u : 0u;
    hitCount += tree.isOccluded(ray, steps, options) ? 1u : 0u;
    hitCount += tree.findIntersections(ray, hits, options).count;
    if (nearest) {
      hitCount += tree.findNextIntersections(ray, *nearest, hits, options).count;
      hitCount += tree.findNextIntersection(ray, *nearest, options).has_value() ? 1u : 0u;
    }
    Hit<T> best;
    hitCount += tree.findIntersection(tree.root(), ray, best, T(0), T(100)) ? 1u : 0u;
    hitCount += tree.bounds().isEmpty() ? 0u : 1u;
  }
}

/// Asks with every kind of options; every request for memory would fail.
template <class O>
std::uint64_t requestsOfQueries(const KdTree<O>& tree) {
  using T = ScalarOf<O>;
  const auto rays = someRays<T>(500);
  std::vector<Hit<T>> hits(4);
  const auto isEven = [](const Hit<T>& hit, void* /*context*/) noexcept {
    return hit.primitive % 2 == 0;
  };
  const HitFilter filter(static_cast<bool (*)(const Hit<T>&, void*) noexcept>(isEven));
  std::uint64_t hitCount = 0;
  const MemoryFaults faults(FaultKind::FromThenOn, 1);
  for (const QueryOptions& options :
       {QueryOptions{}, QueryOptions{.mask = 1}, QueryOptions{.cullsBackFaces = true},
        QueryOptions{.crossings = true}, QueryOptions{.skip = {0, 1}},
        QueryOptions{.filter = filter}}) {
    askAll<O, T>(tree, rays, options, hits, hitCount);
  }
  const KdTree<O> copy = tree;
  static_cast<void>(copy);
  faults.end();
  EXPECT_GT(hitCount, 0u);
  return MemoryFaults::requestCount();
}

TYPED_TEST(BuildingWithoutMemory, IsNoMatterToQueriesOfSingleRays) {
  using T = TypeParam;
  EXPECT_EQ(requestsOfQueries(buildTree(smallMesh<T>())), 0u);
  EXPECT_EQ(requestsOfQueries(buildTree(largeMesh<T>())), 0u);
  EXPECT_EQ(requestsOfQueries(buildTree(mixedScene(smallMesh<T>()))), 0u);
}

}  // namespace
}  // namespace planetree::test
