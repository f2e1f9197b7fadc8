#include "support/random.hpp"
#include "unit/shape/random_shapes.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/shape/shapes.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <variant>
#include <vector>

// Shapes keep what object.hpp asks of them: with it, a tree gives bit for bit the hits of testing
// every shape by itself, whatever the shapes and wherever it cuts them.
namespace planetree::test {
namespace {

template <class T>
using AnyOf = std::variant<Triangle<T>, Sphere<T>, Box<T>, Square<T>, Cylinder<T>, Cone<T>>;

template <class T>
[[nodiscard]] AnyOf<T> randomObject(const Vec3d& center, double size, Random& random) {
  switch (random.below(6)) {
    case 0:
      return MakeShape<Triangle<T>>::at(center, size, random);
    case 1:
      return MakeShape<Sphere<T>>::at(center, size, random);
    case 2:
      return MakeShape<Box<T>>::at(center, size, random);
    case 3:
      return MakeShape<Square<T>>::at(center, size, random);
    case 4:
      return MakeShape<Cylinder<T>>::at(center, size, random);
    default:
      return MakeShape<Cone<T>>::at(center, size, random);
  }
}

/// The next hit by testing every shape.
template <class T>
[[nodiscard]] std::optional<Hit<T>> nearestOfAll(const std::vector<AnyOf<T>>& objects,
                                                 const Ray<T>& ray) {
  std::optional<Hit<T>> nearest;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    auto hit = objectIntersect(objects[i], ray, ray.tMin, ray.tMax);
    if (!hit)
      continue;
    hit->geometry = 0;
    hit->primitive = static_cast<std::uint32_t>(i);
    if (!nearest || isBefore(*hit, *nearest))
      nearest = hit;
  }
  return nearest;
}

template <class T>
class ShapesInTree : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ShapesInTree, Scalars);

TYPED_TEST(ShapesInTree, AreHitAsByTestingEachOne) {
  using T = TypeParam;
  SCOPED_TRACE(describeSeed());
  constexpr int kRayCount = 1000;
  Random random;
  for (const double size : {0.02, 0.2}) {
    for (const double scale : {0x1p-20, 1.0, 0x1p20}) {
      std::vector<AnyOf<T>> objects;
      for (int i = 0; i < 200; ++i) {
        objects.push_back(randomObject<T>(inCube(random, scale), size * scale, random));
      }
      const KdTree<AnyOf<T>> tree = buildTree(objects);
      ASSERT_EQ(tree.report().skippedCount, 0u);
      int hitCount = 0;
      for (int i = 0; i < kRayCount; ++i) {
        const AnyOf<T>& aim = objects[random.below(objects.size())];
        Ray<T> ray = std::visit([&](const auto& shape) { return randomRay(shape, random); }, aim);
        // Walk through all hits, so that rays start on every surface.
        for (int j = 0; j < 6; ++j) {
          const auto expected = nearestOfAll(objects, ray);
          ASSERT_EQ(tree.findIntersection(ray), expected) << "ray " << i << ", hit " << j;
          ASSERT_EQ(tree.isOccluded(ray), expected.has_value());
          if (!expected)
            break;
          ++hitCount;
          ray.tMin = nextUp(expected->t);
        }
      }
      EXPECT_GT(hitCount, kRayCount);
    }
  }
}

TYPED_TEST(ShapesInTree, AreSkippedAndCountedWithoutSurface) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN();
  const std::vector<AnyOf<T>> objects = {
      Sphere<T>{},
      Sphere<T>{{}, T(0)},
      Cone<T>{{nan, T(0), T(0)}},
      Box<T>{{T(1), T(1), T(1)}, {T(0), T(0), T(0)}},
      Square<T>{{}, {}, {}},
      Cylinder<T>{{}, {T(0), T(0), nan}},
      Triangle<T>{{}, {}, {nan, T(0), T(0)}},
  };
  const KdTree<AnyOf<T>> tree = buildTree(objects);
  EXPECT_EQ(tree.report().objectCount, 7u);
  EXPECT_EQ(tree.report().skippedCount, 6u);
  ASSERT_EQ(tree.report().skipped.size(), 6u);
  EXPECT_EQ(tree.report().skipped[0].reason, SkipReason::Empty);
  EXPECT_EQ(tree.report().skipped[1].reason, SkipReason::NotFinite);
  EXPECT_EQ(tree.report().skipped[2].reason, SkipReason::Empty);
  EXPECT_EQ(tree.report().skipped[3].reason, SkipReason::Empty);
  EXPECT_EQ(tree.report().skipped[4].reason, SkipReason::NotFinite);
  EXPECT_EQ(tree.report().skipped[5].reason, SkipReason::NotFinite);
  EXPECT_EQ(tree.findIntersection({{T(0), T(0), T(-5)}, {T(0), T(0), T(1)}})->primitive, 0u);
}

}  // namespace
}  // namespace planetree::test
