#include <planetree/geometry/ray.hpp>
#include <planetree/geometry/sheared_ray.hpp>

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <limits>

namespace planetree {
namespace {

template <class T>
class RayOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RayOf, Scalars);

TYPED_TEST(RayOf, IsEightScalarsInTheOrderOfItsMembers) {
  using T = TypeParam;
  const std::array<T, 16> rows = {1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 13, 14, 15, 16, 17, 18};
  const auto rays = std::bit_cast<std::array<Ray<T>, 2>>(rows);
  EXPECT_EQ(rays[0].origin, (Vec3<T>{1, 2, 3}));
  EXPECT_EQ(rays[0].direction, (Vec3<T>{4, 5, 6}));
  EXPECT_EQ(rays[0].tMin, T(7));
  EXPECT_EQ(rays[0].tMax, T(8));
  EXPECT_EQ(rays[1].origin, (Vec3<T>{11, 12, 13}));
  EXPECT_EQ(rays[1].tMax, T(18));
}

TYPED_TEST(RayOf, StartsAtZeroAndNeverEndsUnlessToldOtherwise) {
  using T = TypeParam;
  const Ray<T> ray{{T(1), T(2), T(3)}, {T(0), T(0), T(1)}};
  EXPECT_EQ(ray.tMin, T(0));
  EXPECT_EQ(ray.tMax, std::numeric_limits<T>::infinity());
}

TYPED_TEST(RayOf, CountsTInDirectionLengths) {
  using T = TypeParam;
  const Ray<T> ray{{T(1), T(2), T(3)}, {T(0), T(4), T(0)}};
  EXPECT_EQ(ray.at(T(0.5)), (Vec3<T>{T(1), T(4), T(3)}));
  EXPECT_EQ(ray.at(T(-1)), (Vec3<T>{T(1), T(-2), T(3)}));
}

TYPED_TEST(RayOf, IsShearedAlongItsLargestComponent) {
  using T = TypeParam;
  for (const Axis axis : kAxes) {
    Ray<T> ray{{}, {T(1), T(-2), T(0.5)}};
    ray.direction[axis] = T(-8);
    const ShearedRay<T> sheared(ray);
    EXPECT_EQ(sheared.kz, axis);
    EXPECT_TRUE(sheared.kx != sheared.ky && sheared.kx != axis && sheared.ky != axis);
    EXPECT_EQ(sheared.shearX, ray.direction[sheared.kx] / T(-8));
    EXPECT_EQ(sheared.shearY, ray.direction[sheared.ky] / T(-8));
  }
}

}  // namespace
}  // namespace planetree
