#include <planetree/planetree.hpp>

#include "support/brute_force_hits.hpp"
#include "support/build_variants.hpp"
#include "support/flush_to_zero.hpp"
#include "support/hard_cases.hpp"
#include "support/print_hit.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace planetree::test {
namespace {

template <class T>
class QueryChoices : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(QueryChoices, Scalars);

/// Rejects about every other hit, by its ids, its part and where on the object it is.
template <class T>
bool acceptsByTheLook(const Hit<T>& hit, void* /*context*/) noexcept {
  return ((hit.primitive * 7 + hit.part + hit.geometry) & 2u) != 0 || hit.u > T(0.4);
}

/// All choices, alone and together. `skipped` is an object that some ray hits.
template <class T>
std::vector<QueryOptions> choices(const PrimitiveId& skipped) {
  const HitFilter filter(acceptsByTheLook<T>);
  std::vector<QueryOptions> all(1);
  all.push_back({.cullsBackFaces = true});
  all.push_back({.crossings = true});
  all.push_back({.skip = skipped});
  all.push_back({.filter = filter});
  all.push_back({.mask = 3, .filter = filter});
  all.push_back({.mask = 6, .cullsBackFaces = true, .skip = skipped});
  all.push_back({.cullsBackFaces = true, .crossings = true, .skip = skipped, .filter = filter});
  return all;
}

/// Every query against the sorted hits of brute force.
template <class T, class Tree>
void expectAnswers(const Tree& tree, const Ray<T>& ray, const QueryOptions& options) {
  const std::vector<Hit<T>> expected = bruteForceHits(tree, ray, options);
  const auto nearest = expected.empty() ? std::nullopt : std::optional(expected.front());
  StepCounts steps;  // with it the binary form is asked
  ASSERT_EQ(tree.findIntersection(ray, options), nearest);
  ASSERT_EQ(tree.findIntersection(ray, steps, options), nearest);
  ASSERT_EQ(tree.isOccluded(ray, options), nearest.has_value());
  ASSERT_EQ(tree.isOccluded(ray, steps, options), nearest.has_value());

  std::vector<Hit<T>> all(expected.size() + 1);
  ASSERT_EQ(tree.findIntersections(ray, all, options),
            (FoundHits{.count = expected.size(), .hasMore = false}));
  all.pop_back();
  ASSERT_EQ(all, expected);
  std::fill(all.begin(), all.end(), Hit<T>{});
  ASSERT_EQ(findIntersections<T>(tree.view(), ray, all, options, &steps),
            (FoundHits{.count = expected.size(), .hasMore = false}));
  ASSERT_EQ(all, expected);

  for (const std::size_t room : {std::size_t{0}, std::size_t{1}, std::size_t{3}}) {
    std::vector<Hit<T>> first(std::min(room, expected.size()));
    ASSERT_EQ(tree.findIntersections(ray, first, options),
              (FoundHits{.count = first.size(), .hasMore = first.size() < expected.size()}));
    ASSERT_TRUE(std::equal(first.begin(), first.end(), expected.begin()));
    if (first.empty())
      continue;
    std::vector<Hit<T>> rest(expected.size());
    const FoundHits found = tree.findNextIntersections(ray, first.back(), rest, options);
    ASSERT_EQ(found, (FoundHits{.count = expected.size() - first.size(), .hasMore = false}));
    rest.resize(found.count);
    ASSERT_TRUE(std::equal(rest.begin(), rest.end(),
                           expected.end() - static_cast<std::ptrdiff_t>(found.count)));
  }

  std::size_t count = 0;
  for (auto hit = tree.findIntersection(ray, options); hit && count <= expected.size();
       hit = tree.findNextIntersection(ray, *hit, options))
    ASSERT_EQ(*hit, expected[count++]);
  ASSERT_EQ(count, expected.size());
}

/// What a walk tells, against the query that it explains.
template <class T, class Tree>
void expectExplained(const Tree& tree, const Ray<T>& ray, const QueryOptions& options) {
  StepCounts steps;
  const auto hit = tree.findIntersection(ray, steps, options);
  const Walk<T> walk = tree.explainIntersection(ray, options);
  ASSERT_EQ(walk.hit, hit);
  ASSERT_EQ(walk.counts.leafNodes, steps.leafNodes);
  ASSERT_EQ(walk.counts.splitNodes, steps.splitNodes);
  ASSERT_EQ(walk.counts.objects, steps.objects);
  const Walk<T> shadow = tree.explainOcclusion(ray, options);
  ASSERT_EQ(shadow.hit.has_value(), hit.has_value());
}

template <class T>
void agreesOnHardCases(int rayCount) {
  std::uint64_t salt = 7000;
  for (const HardMesh<T>& hard : hardMeshes<T>()) {
    for (const auto& [variant, build] : buildVariants()) {
      SCOPED_TRACE(variant);
      SCOPED_TRACE(hard.name + ", " + describeSeed());
      const KdTree<Face<T>> tree = buildTree(hard.mesh.view(), build);
      const auto rays = hardRays(hard.mesh, tree.bounds(), rayCount, ++salt);
      PrimitiveId skipped;
      for (const Ray<T>& ray : rays) {
        if (const auto hit = tree.findIntersection(ray))
          skipped = {hit->geometry, hit->primitive};
      }
      for (const Ray<T>& ray : rays) {
        for (const QueryOptions& options : choices<T>(skipped)) {
          expectAnswers(tree, ray, options);
          if (testing::Test::HasFatalFailure())
            return;
        }
      }
    }
  }
}

TYPED_TEST(QueryChoices, AgreeBitForBitWithBruteForceOnHardCases) {
  agreesOnHardCases<TypeParam>(30);
}

TYPED_TEST(QueryChoices, AgreeBitForBitWithBruteForceWhenDenormalsAreFlushed) {
  const FlushToZero mode(true);
  agreesOnHardCases<TypeParam>(10);
}

template <class T>
using Any = std::variant<Sphere<T>, Box<T>, Square<T>, Cylinder<T>, Cone<T>, Triangle<T>>;

/// Everything that a tree can hold, with duplicates and touching shapes, so that many hits share a
/// t.
template <class T>
Scene<T> mixedScene() {
  Random random(71);
  const auto point = [&] { return random.pointIn<T>({-1, -1, -1}, {1, 1, 1}); };
  const auto small = [&] { return static_cast<T>(random.between(0.05, 0.3)); };
  std::vector<Any<T>> shapes;
  std::vector<std::unique_ptr<Geometry<T>>> virtualShapes;
  for (int i = 0; i < 25; ++i) {
    const Vec3<T> at = point();
    const Vec3<T> size{small(), small(), small()};
    shapes.push_back(Box<T>{at, at + size});
    shapes.push_back(Box<T>{{at.x + size.x, at.y, at.z}, at + size + Vec3<T>{small(), T(0), T(0)}});
    shapes.push_back(Sphere<T>{at, small()});
    shapes.push_back(shapes.back());
    shapes.push_back(Square<T>{at, point() * T(0.2), point() * T(0.2)});
    shapes.push_back(Cylinder<T>{at, point() * T(0.3), small(), random.chance(0.5)});
    shapes.push_back(Triangle<T>{at, point(), point()});
    virtualShapes.push_back(makeGeometry(Cone<T>{point(), point() * T(0.3), small(), T(0), true}));
    virtualShapes.push_back(makeGeometry(Triangle<T>{at, point(), point()}));
  }
  virtualShapes.push_back(nullptr);
  const TriangleMesh<T> soup = detail::soup<T>(72, 150, 0.3);
  Scene<T> scene;
  scene.add(std::move(shapes));
  scene.add(soup, {.mask = 2});
  scene.add(std::move(virtualShapes), {.mask = 4});
  scene.add(soup, {.mask = 9});
  return scene;
}

TYPED_TEST(QueryChoices, AgreeBitForBitWithBruteForceOnShapesAndMeshesInOneTree) {
  using T = TypeParam;
  const Scene<T> scene = mixedScene<T>();
  for (const auto& [variant, build] : buildVariants()) {
    SCOPED_TRACE(variant);
    SCOPED_TRACE(describeSeed());
    const KdTree<AnyObject<T>> tree = buildTree(scene, build);
    for (const Ray<T>& ray : hardRays(detail::soup<T>(72, 150, 0.3), tree.bounds(), 120, 73)) {
      for (const QueryOptions& options : choices<T>({0, 42})) {
        expectAnswers(tree, ray, options);
        expectExplained(tree, ray, options);
        if (testing::Test::HasFatalFailure())
          return;
      }
    }
  }
}

TYPED_TEST(QueryChoices, FindNothingForRaysThatMissByDefinition) {
  using T = TypeParam;
  const auto tree = buildTree(mixedScene<T>());
  for (const Ray<T>& ray : invalidRays<T>()) {
    for (const QueryOptions& options : choices<T>({0, 42}))
      expectAnswers(tree, ray, options);
  }
  const Ray<T> ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}};
  Hit<T> notANumber;
  notANumber.t = std::numeric_limits<T>::quiet_NaN();
  EXPECT_EQ(tree.findNextIntersection(ray, notANumber), std::nullopt);
  EXPECT_EQ(tree.findNextIntersection(ray, Hit<T>{}), std::nullopt);
}

TYPED_TEST(QueryChoices, AFilterIsForOnePrecision) {
  using T = TypeParam;
  using Other = std::conditional_t<std::is_same_v<T, float>, double, float>;
  const auto tree = buildTree(std::vector<Sphere<T>>{{}});
  const Ray<T> ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}};
  bool (*const accepts)(const Hit<T>&, void*) noexcept = [](const Hit<T>&, void*) noexcept {
    return true;
  };
  bool (*const others)(const Hit<Other>&, void*) noexcept = [](const Hit<Other>&, void*) noexcept {
    return true;
  };
  EXPECT_TRUE(tree.findIntersection(ray, {.filter = accepts}));
  EXPECT_FALSE(tree.findIntersection(ray, {.filter = others}));
}

TYPED_TEST(QueryChoices, AFilterSeesTheWholeHitAndItsContext) {
  using T = TypeParam;
  const auto tree = buildTree(mixedScene<T>());
  const Ray<T> ray{.origin = {T(0.1), T(0.2), 5}, .direction = {0, 0, -1}};
  const auto known = bruteForceHits(tree, ray);
  struct Witness {
    const std::vector<Hit<T>>& known;
    std::size_t count = 0;
    bool sawAnother = false;
  } witness{known};
  const HitFilter rejectsAll(
      [](const Hit<T>& hit, void* context) noexcept {
        Witness& seen = *static_cast<Witness*>(context);
        ++seen.count;
        seen.sawAnother |= std::find(seen.known.begin(), seen.known.end(), hit) == seen.known.end();
        return false;
      },
      &witness);
  ASSERT_GT(known.size(), 2u);
  EXPECT_FALSE(tree.findIntersection(ray, {.filter = rejectsAll}));
  EXPECT_FALSE(witness.sawAnother);
  EXPECT_GE(witness.count, known.size());
}

}  // namespace
}  // namespace planetree::test
