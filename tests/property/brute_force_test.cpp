#include <planetree/planetree.hpp>

#include "support/brute_force.hpp"
#include "support/build_variants.hpp"
#include "support/flush_to_zero.hpp"
#include "support/hard_cases.hpp"
#include "support/print_hit.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

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
std::string describe(const Ray<T>& ray) {
  std::ostringstream text;
  text.precision(17);
  text << "ray (" << ray.origin.x << ", " << ray.origin.y << ", " << ray.origin.z << ") + t ("
       << ray.direction.x << ", " << ray.direction.y << ", " << ray.direction.z << "), t in ["
       << ray.tMin << ", " << ray.tMax << "]";
  return text.str();
}

template <class T>
class BruteForce : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BruteForce, Scalars);

template <class T>
void agreesOnHardCases(bool flushesToZero) {
  const FlushToZero mode(flushesToZero);
  std::uint64_t salt = 100;
  for (const HardMesh<T>& hard : hardMeshes<T>()) {
    for (const auto& [variant, options] : buildVariants()) {
      SCOPED_TRACE(hard.name + ", " + variant + ", " + describeSeed());
      const KdTree<Face<T>> tree = buildTree(hard.mesh.view(), options);
      for (const Ray<T>& ray : hardRays(hard.mesh, tree.bounds(), 300, ++salt)) {
        const auto expected = bruteForce(tree, ray);
        ASSERT_EQ(tree.findIntersection(ray), expected) << describe(ray);
        ASSERT_EQ(tree.isOccluded(ray), expected.has_value()) << describe(ray);
        Hit<T> hit;
        ASSERT_EQ(tree.findIntersection(tree.root(), ray, hit, ray.tMin, ray.tMax),
                  expected.has_value())
            << describe(ray);
        ASSERT_EQ(hit, expected.value_or(Hit<T>{})) << describe(ray);
      }
      for (const Ray<T>& ray : invalidRays<T>()) {
        ASSERT_EQ(tree.findIntersection(ray), std::nullopt) << describe(ray);
        ASSERT_FALSE(tree.isOccluded(ray)) << describe(ray);
      }
    }
  }
}

TYPED_TEST(BruteForce, AgreesBitForBitOnHardCases) {
  agreesOnHardCases<TypeParam>(false);
}
TYPED_TEST(BruteForce, AgreesBitForBitOnHardCasesWhenDenormalsAreFlushed) {
  agreesOnHardCases<TypeParam>(true);
}

TYPED_TEST(BruteForce, AgreesOnMixedShapesAndMeshesInOneTree) {
  using T = TypeParam;
  using Any = std::variant<Sphere<T>, Box<T>, Square<T>, Cylinder<T>, Cone<T>, Triangle<T>>;
  Random random(7);
  const auto point = [&] { return random.pointIn<T>({-1, -1, -1}, {1, 1, 1}); };
  const auto small = [&] { return static_cast<T>(random.between(0.02, 0.2)); };
  std::vector<Any> shapes;
  std::vector<std::unique_ptr<Geometry<T>>> virtualShapes;
  std::vector<Sphere<T>> spheres;
  for (int i = 0; i < 40; ++i) {
    const Vec3<T> at = point();
    shapes.push_back(Box<T>{at, at + Vec3<T>{small(), small(), small()}});
    shapes.push_back(Square<T>{at, point() * T(0.2), point() * T(0.2)});
    shapes.push_back(Cylinder<T>{at, point() * T(0.3), small(), random.chance(0.5)});
    shapes.push_back(Cone<T>{point(), point() * T(0.3), small(), small(), random.chance(0.5)});
    shapes.push_back(Triangle<T>{at, point(), point()});
    virtualShapes.push_back(makeGeometry(Sphere<T>{point(), small()}));
    virtualShapes.push_back(makeGeometry(Cone<T>{point(), point() * T(0.3), small(), T(0), true}));
    spheres.push_back(Sphere<T>{point(), small()});
  }
  virtualShapes.push_back(nullptr);

  Scene<T> scene;
  scene.add(std::move(shapes));
  scene.add(detail::soup<T>(8, 200, 0.2), {.mask = 2});
  scene.add(TriangleMesh<T>{});
  scene.add(std::move(virtualShapes), {.mask = 4});
  scene.add(std::span<const Sphere<T>>(spheres));
  for (const auto& [variant, options] : buildVariants()) {
    SCOPED_TRACE(variant + ", " + describeSeed());
    const KdTree<AnyObject<T>> tree = buildTree(scene, options);
    EXPECT_EQ(tree.report().skippedCount, 1u);
    for (const Ray<T>& ray : hardRays(TriangleMesh<T>{}, tree.bounds(), 2000, 9)) {
      const auto expected = bruteForce(tree, ray);
      ASSERT_EQ(tree.findIntersection(ray), expected) << describe(ray);
      ASSERT_EQ(tree.isOccluded(ray), expected.has_value()) << describe(ray);
      const auto masked = bruteForce(tree, ray, 2);
      ASSERT_EQ(tree.findIntersection(ray, {.mask = 2}), masked) << describe(ray);
      ASSERT_EQ(tree.isOccluded(ray, {.mask = 2}), masked.has_value()) << describe(ray);
    }
  }
}

}  // namespace
}  // namespace planetree::test
