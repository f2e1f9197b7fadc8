#include <planetree/mesh/triangle_intersection.hpp>

#include "support/flush_to_zero.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace planetree::test {
namespace {

template <class T>
constexpr T kInfinity = std::numeric_limits<T>::infinity();

template <class T>
class TriangleTest : public testing::Test {
 protected:
  using Vector = Vec3<T>;
  const Vector a_{0, 0, 0};
  const Vector b_{4, 0, 0};
  const Vector c_{0, 4, 0};

  auto intersect(const Ray<T>& ray, T tMin = -kInfinity<T>, T tMax = kInfinity<T>) const {
    return intersectTriangle(ShearedRay<T>(ray), a_, b_, c_, tMin, tMax);
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(TriangleTest, Scalars);

TYPED_TEST(TriangleTest, GivesDistanceAndWeights) {
  const auto hit = this->intersect({{1, 2, 3}, {0, 0, -2}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, TypeParam(1.5));
  EXPECT_EQ(hit->u, TypeParam(0.25));
  EXPECT_EQ(hit->v, TypeParam(0.5));
}

TYPED_TEST(TriangleTest, IsHitFromBothSides) {
  EXPECT_TRUE(this->intersect({{1, 1, 3}, {0, 0, -1}}));
  EXPECT_TRUE(this->intersect({{1, 1, -3}, {0, 0, 1}}));
}

TYPED_TEST(TriangleTest, IsHitOnItsEdgesAndCorners) {
  for (const auto& [x, y] : {std::pair(0, 0), {4, 0}, {0, 4}, {2, 0}, {0, 2}, {2, 2}}) {
    EXPECT_TRUE(
        this->intersect({{static_cast<TypeParam>(x), static_cast<TypeParam>(y), 3}, {0, 0, -1}}))
        << x << ", " << y;
  }
}

TYPED_TEST(TriangleTest, IsMissedJustOutside) {
  // Of double numbers those below 2^-400 count as zero.
  const auto outside =
      std::is_same_v<TypeParam, float> ? nextDown(TypeParam(0)) : TypeParam(-0x1p-400);
  EXPECT_FALSE(this->intersect({{outside, 1, 3}, {0, 0, -1}}));
  EXPECT_FALSE(this->intersect({{1, TypeParam(-1e-6), 3}, {0, 0, -1}}));
  EXPECT_FALSE(this->intersect({{nextUp(TypeParam(2)), nextUp(TypeParam(2)), 3}, {0, 0, -1}}));
}

TYPED_TEST(TriangleTest, CountsOnlyInTheClosedInterval) {
  const Ray<TypeParam> ray{{1, 1, 3}, {0, 0, -1}};
  EXPECT_TRUE(this->intersect(ray, 3, 3));
  EXPECT_FALSE(this->intersect(ray, nextUp(TypeParam(3)), 4));
  EXPECT_FALSE(this->intersect(ray, 2, nextDown(TypeParam(3))));
  EXPECT_TRUE(this->intersect({{1, 1, -3}, {0, 0, -1}}, -3, 0));
}

TYPED_TEST(TriangleTest, IsMissedByRaysThatPointNowhere) {
  const TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
  const TypeParam infinity = kInfinity<TypeParam>;
  for (const Vec3<TypeParam>& direction :
       {Vec3<TypeParam>{0, 0, 0}, Vec3<TypeParam>{nan, 0, -1}, Vec3<TypeParam>{0, nan, -1},
        Vec3<TypeParam>{0, 0, nan}, Vec3<TypeParam>{0, 0, -infinity},
        Vec3<TypeParam>{infinity, 0, -1}}) {
    EXPECT_FALSE(this->intersect({{1, 1, 3}, direction}));
  }
  EXPECT_FALSE(this->intersect({{nan, 1, 3}, {0, 0, -1}}));
  EXPECT_FALSE(this->intersect({{1, infinity, 3}, {0, 0, -1}}));
}

TYPED_TEST(TriangleTest, IsMissedByRaysInItsPlane) {
  EXPECT_FALSE(this->intersect({{-1, 1, 0}, {1, 0, 0}}));
  EXPECT_FALSE(this->intersect({{-1, 0, 0}, {1, 0, 0}}));
}

// Products of such numbers underflow, and t came out anywhere along the triangle.
TYPED_TEST(TriangleTest, PutsTheHitOnTheRayADenormalOffItsPlane) {
  using T = TypeParam;
  const Vec3<T> a{-1, T(-0.5), 0};
  const Vec3<T> b{T(-0.5), 0, 0};
  const Vec3<T> c{-1, 0, 0};
  const T denormal = std::numeric_limits<T>::denorm_min();
  for (const T off : {T(0), denormal, -denormal, 3 * denormal}) {
    for (const T slope : {denormal, -denormal, 3 * denormal, std::numeric_limits<T>::min()}) {
      const Ray<T> ray{{0, 0, off}, {T(0.3125), T(0.3125), slope}};
      const auto hit = intersectTriangle(ShearedRay<T>(ray), a, b, c, -kInfinity<T>, kInfinity<T>);
      if (hit) {
        const Vec3<T> point = a + (b - a) * hit->u + (c - a) * hit->v;
        EXPECT_NEAR(point.x, ray.at(hit->t).x, 1e-5) << off << ", " << slope;
      }
    }
  }
}

TYPED_TEST(TriangleTest, WithTwoEqualCornersIsNeverHit) {
  Random random(61);
  for (int i = 0; i < 20'000; ++i) {
    const auto a = random.pointIn<TypeParam>({-1, -1, -1}, {1, 1, 1});
    const auto b = random.pointIn<TypeParam>({-1, -1, -1}, {1, 1, 1});
    const auto origin = random.pointIn<TypeParam>({-2, -2, -2}, {2, 2, 2});
    const auto target = a + (b - a) * static_cast<TypeParam>(random.unit());
    const ShearedRay<TypeParam> ray(Ray<TypeParam>{origin, target - origin});
    ASSERT_FALSE(intersectTriangle(ray, a, b, b, TypeParam(0), kInfinity<TypeParam>));
    ASSERT_FALSE(intersectTriangle(ray, a, a, b, TypeParam(0), kInfinity<TypeParam>));
    ASSERT_FALSE(intersectTriangle(ray, b, a, b, TypeParam(0), kInfinity<TypeParam>));
  }
}

/// Rays aimed at the shared edge of two triangles, and at the shared vertex of a fan.
template <class T>
void losesNoRayAtSharedEdges(bool flushesToZero) {
  const FlushToZero mode(flushesToZero);
  Random random(62);
  for (int i = 0; i < 300'000; ++i) {
    const double scale = std::exp2(std::floor(random.between(-30, 30)));
    const auto point = [&] {
      return static_cast<Vec3<T>>(random.pointIn<double>({-1, -1, -1}, {1, 1, 1}) * scale);
    };
    const Vec3<T> a = point();
    const Vec3<T> b = point();
    const Vec3<T> c = a + (b - a) * T(0.5) + static_cast<Vec3<T>>(random.direction() * scale);
    const Vec3<T> d = a + b - c;  // on the other side of the edge, nearly
    const Vec3<T> origin = point() * T(3);
    const Vec3<T> target = a + (b - a) * static_cast<T>(random.between(0.01, 0.99));
    const ShearedRay<T> ray(Ray<T>{origin, target - origin});
    const bool hit = intersectTriangle(ray, a, b, c, T(0), kInfinity<T>).has_value() ||
                     intersectTriangle(ray, b, a, d, T(0), kInfinity<T>).has_value();
    // Seen edge-on, both triangles may lie on one side of the edge: only then may the ray pass.
    if (!hit) {
      const Vec3d direction = static_cast<Vec3d>(target - origin);
      const Vec3d edge = static_cast<Vec3d>(b - a);
      const Vec3d side = cross(direction, edge);
      const double sideOfC = dot(side, static_cast<Vec3d>(c - a));
      const double sideOfD = dot(side, static_cast<Vec3d>(d - a));
      const double roundoff = 1e-5 * length(side) * scale;
      ASSERT_TRUE(sideOfC * sideOfD > 0 || std::fabs(sideOfC) < roundoff) << describeSeed();
    }
  }
}

TYPED_TEST(TriangleTest, LosesNoRayAtASharedEdge) {
  losesNoRayAtSharedEdges<TypeParam>(false);
}
TYPED_TEST(TriangleTest, LosesNoRayAtASharedEdgeWhenDenormalsAreFlushed) {
  losesNoRayAtSharedEdges<TypeParam>(true);
}

/// Distance of the point at t from the triangle's plane point with the same weights: the error that
/// the slack of the traversal has to cover.
TYPED_TEST(TriangleTest, PutsTheHitWithinTheDocumentedDistanceOfTheTriangle) {
  using T = TypeParam;
  const long double roundoff = std::numeric_limits<T>::epsilon() / 2;
  const long double allowed = std::is_same_v<T, float> ? 8 : 25;
  Random random(63);
  long double worst = 0;
  int hits = 0;
  for (int i = 0; i < 300'000; ++i) {
    // Slivers down to a width of the roundoff, seen from near and far.
    const auto a = random.pointIn<T>({-1, -1, -1}, {1, 1, 1});
    const auto b = random.pointIn<T>({-1, -1, -1}, {1, 1, 1});
    const auto c = a + (b - a) * static_cast<T>(random.unit()) +
                   static_cast<Vec3<T>>(random.direction() * std::exp2(random.between(-26, 0)));
    const double weightB = random.unit();
    const double weightC = random.unit() * (1 - weightB);
    const auto target = a + (b - a) * static_cast<T>(weightB) + (c - a) * static_cast<T>(weightC);
    const auto origin =
        target + static_cast<Vec3<T>>(random.direction() * std::exp2(random.between(-4, 10)));
    const Ray<T> ray{origin, (target - origin) * static_cast<T>(std::exp2(random.between(-8, 8)))};
    const auto hit = intersectTriangle(ShearedRay<T>(ray), a, b, c, T(0), kInfinity<T>);
    if (!hit)
      continue;
    ++hits;
    long double distance = 0;
    for (const Vec3<T>& corner : {a, b, c}) {
      for (const Axis axis : kAxes) {
        distance = std::max(distance, std::fabs(static_cast<long double>(corner[axis]) -
                                                static_cast<long double>(origin[axis])));
      }
    }
    // u and v are rounded to T, which moves the point along the triangle by as much again.
    for (const Axis axis : kAxes) {
      const auto at = [axis](const Vec3<T>& p) { return static_cast<long double>(p[axis]); };
      const long double onRay =
          at(ray.origin) + static_cast<long double>(hit->t) * at(ray.direction);
      const long double onTriangle = at(a) + static_cast<long double>(hit->u) * (at(b) - at(a)) +
                                     static_cast<long double>(hit->v) * (at(c) - at(a));
      const long double uvRounding =
          roundoff * (std::fabs(at(b) - at(a)) + std::fabs(at(c) - at(a)));
      worst = std::max(worst, (std::fabs(onRay - onTriangle) - uvRounding) / (roundoff * distance));
    }
  }
  EXPECT_GT(hits, 200'000);
  EXPECT_LE(worst, allowed) << describeSeed();
  this->RecordProperty("worst_error_in_roundoffs", static_cast<int>(std::ceil(worst)));
}

TYPED_TEST(TriangleTest, NormalIsUnitAndCounterClockwise) {
  using T = TypeParam;
  EXPECT_EQ(triangleNormal<T>({0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 1}), (Vec3<T>{0, 0, 1}));
  EXPECT_EQ(triangleNormal<T>({0, 0, 0}, {0, 3, 0}, {2, 0, 0}, {0, 0, 1}), (Vec3<T>{0, 0, -1}));
  const T tiny = std::numeric_limits<T>::min();
  EXPECT_EQ(triangleNormal<T>({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, 1}),
            (Vec3<T>{0, 0, 1}));
  const T huge = T(0x1p100);
  EXPECT_EQ(triangleNormal<T>({0, 0, 0}, {huge, 0, 0}, {0, huge, 0}, {0, 0, 1}),
            (Vec3<T>{0, 0, 1}));
}

TYPED_TEST(TriangleTest, NormalWithoutAreaFacesTheRay) {
  using T = TypeParam;
  EXPECT_EQ(triangleNormal<T>({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 0, -5}), (Vec3<T>{0, 0, 1}));
}

}  // namespace
}  // namespace planetree::test
