#include "support/random.hpp"
#include "unit/shape/random_shapes.hpp"
#include "unit/shape/reference_shapes.hpp"
#include "unit/shape/shape_checks.hpp"

#include <planetree/shape/shapes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

// What must hold for any shape and any ray, tried on random ones of all sizes and positions.
namespace planetree::test {
namespace {

constexpr int kShapeCount = 200;
constexpr int kRaysPerShape = 60;

template <class S>
using RayOf = Ray<typename S::Scalar>;
template <class S>
using HitOf = Hit<typename S::Scalar>;

/// Calls `check` with random shapes and rays, all made from one seed, until one fails.
template <class S, class Check>
void forRandomRays(Check&& check) {
  SCOPED_TRACE(describeSeed());
  Random random;
  for (int i = 0; i < kShapeCount; ++i) {
    const S shape = randomShape<S>(random);
    for (int j = 0; j < kRaysPerShape; ++j) {
      SCOPED_TRACE(::testing::Message() << "shape " << i << ", ray " << j);
      check(shape, randomRay(shape, random));
      if (::testing::Test::HasFailure())
        return;
    }
  }
}

template <class S>
class AnyShape : public ::testing::Test {};
using AnyShapeTypes =
    ::testing::Types<Sphere<float>, Sphere<double>, Box<float>, Box<double>, Square<float>,
                     Square<double>, Cylinder<float>, Cylinder<double>, Cone<float>, Cone<double>,
                     Triangle<float>, Triangle<double>>;
TYPED_TEST_SUITE(AnyShape, AnyShapeTypes);

TYPED_TEST(AnyShape, HitsLieInTheBoundsAndOnTheSurface) {
  Real worstExcess = 0;
  Real worstDistance = 0;
  int hitCount = 0;
  forRandomRays<TypeParam>([&](const TypeParam& shape, const RayOf<TypeParam>& ray) {
    const Real rounding = roundingOf(shape, ray);
    for (const HitOf<TypeParam>& hit : allHits(shape, ray)) {
      const Vec3l point = pointAt(shape, ray, hit.t);
      worstExcess = std::max(worstExcess, excess(shape.bounds(), shape, point) / rounding);
      worstDistance = std::max(worstDistance, distance(shape, point) / rounding);
      ++hitCount;
    }
  });
  EXPECT_LE(worstExcess, kAllowedRoundings<typename TypeParam::Scalar>);
  EXPECT_LE(worstDistance, kAllowedRoundings<typename TypeParam::Scalar>);
  EXPECT_GT(hitCount, kShapeCount * kRaysPerShape / 4);
  this->RecordProperty("worstExcess", std::to_string(worstExcess));
  this->RecordProperty("worstDistance", std::to_string(worstDistance));
}

TYPED_TEST(AnyShape, HitsDoNotDependOnTheInterval) {
  using T = typename TypeParam::Scalar;
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  forRandomRays<TypeParam>([&](const TypeParam& shape, const RayOf<TypeParam>& ray) {
    T behind = -kInfinity;
    for (const HitOf<TypeParam>& hit : allHits(shape, ray)) {
      EXPECT_EQ(shape.intersect(ray, hit.t, hit.t), hit);
      EXPECT_EQ(shape.intersect(ray, behind, hit.t), hit);
      EXPECT_EQ(shape.intersect(ray, hit.t, kInfinity), hit);
      EXPECT_EQ(shape.intersect(ray, behind, nextDown(hit.t)), std::nullopt);
      behind = nextUp(hit.t);
    }
    EXPECT_EQ(shape.intersect(ray, behind, kInfinity), std::nullopt);
  });
}

TYPED_TEST(AnyShape, HitsHaveUnitNormalsAndParametersFromZeroToOne) {
  using T = typename TypeParam::Scalar;
  forRandomRays<TypeParam>([&](const TypeParam& shape, const RayOf<TypeParam>& ray) {
    for (const HitOf<TypeParam>& hit : allHits(shape, ray)) {
      EXPECT_NEAR(length(Vec3d(hit.normal)), 1.0, 8.0 * std::numeric_limits<T>::epsilon());
      EXPECT_TRUE(hit.u >= T(0) && hit.u <= T(1)) << hit.u;
      EXPECT_TRUE(hit.v >= T(0) && hit.v <= T(1)) << hit.v;
      EXPECT_EQ(hit.geometry, kNoId);
      EXPECT_EQ(hit.primitive, kNoId);
    }
  });
}

TYPED_TEST(AnyShape, PowersOfTwoInTheDirectionOnlyScaleT) {
  using T = typename TypeParam::Scalar;
  forRandomRays<TypeParam>([&](const TypeParam& shape, RayOf<TypeParam> ray) {
    const std::vector<HitOf<TypeParam>> hits = allHits(shape, ray);
    constexpr T kFactor = T(1024);
    ray.direction = ray.direction * kFactor;
    std::vector<HitOf<TypeParam>> scaled = allHits(shape, ray);
    for (HitOf<TypeParam>& hit : scaled)
      hit.t *= kFactor;
    EXPECT_EQ(scaled, hits);
  });
}

TYPED_TEST(AnyShape, SignsOfZerosDoNotMatter) {
  using T = typename TypeParam::Scalar;
  forRandomRays<TypeParam>([&](const TypeParam& shape, RayOf<TypeParam> ray) {
    const std::vector<HitOf<TypeParam>> hits = allHits(shape, ray);
    for (const Axis axis : kAxes) {
      if (ray.direction[axis] == T(0))
        ray.direction[axis] = -ray.direction[axis];
      if (ray.origin[axis] == T(0))
        ray.origin[axis] = -ray.origin[axis];
    }
    EXPECT_EQ(allHits(shape, ray), hits);
  });
}

TYPED_TEST(AnyShape, RaysThatAreNoRaysMiss) {
  using T = typename TypeParam::Scalar;
  constexpr T kNan = std::numeric_limits<T>::quiet_NaN();
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  const TypeParam shape;
  EXPECT_TRUE(allHits(shape, RayOf<TypeParam>{{}, {}}).empty());
  for (const T bad : {kNan, kInfinity, -kInfinity}) {
    for (const Axis axis : kAxes) {
      RayOf<TypeParam> ray{{T(0.1), T(0.1), T(-2)}, {T(0), T(0), T(1)}};
      ASSERT_FALSE(allHits(shape, ray).empty());
      ray.direction[axis] = bad;
      EXPECT_TRUE(allHits(shape, ray).empty()) << "direction, " << axisName(axis) << " = " << bad;
      ray.direction = {T(0), T(0), T(1)};
      ray.origin[axis] = bad;
      EXPECT_TRUE(allHits(shape, ray).empty()) << "origin, " << axisName(axis) << " = " << bad;
    }
  }
  const RayOf<TypeParam> good{{T(0.1), T(0.1), T(-2)}, {T(0), T(0), T(1)}};
  EXPECT_EQ(shape.intersect(good, kNan, kInfinity), std::nullopt);
  EXPECT_EQ(shape.intersect(good, T(0), kNan), std::nullopt);
  EXPECT_EQ(shape.intersect(good, T(100), T(0)), std::nullopt);
}

TYPED_TEST(AnyShape, ExtremeRaysDoNoHarm) {
  using T = typename TypeParam::Scalar;
  const std::vector<T> extremes = {std::numeric_limits<T>::max(), std::numeric_limits<T>::min(),
                                   std::numeric_limits<T>::denorm_min(), T(1), T(0)};
  for (const T x : extremes) {
    for (const T y : extremes) {
      for (const T z : extremes) {
        for (const Vec3<T>& origin : {Vec3<T>{}, Vec3<T>{x, y, z}, Vec3<T>{-z, x, -y}}) {
          for (const HitOf<TypeParam>& hit :
               allHits(TypeParam{}, RayOf<TypeParam>{origin, {x, y, z}})) {
            EXPECT_TRUE(std::isfinite(hit.t) && isFinite(hit.normal));
          }
        }
      }
    }
  }
}

TYPED_TEST(AnyShape, ClippedBoundsHoldEveryHitInTheCell) {
  using T = typename TypeParam::Scalar;
  Random random(1);
  forRandomRays<TypeParam>([&](const TypeParam& shape, const RayOf<TypeParam>& ray) {
    const Box3 cell = randomCell(shape.bounds(), random);
    const Box3 clipped = objectClippedBounds(shape, cell);
    const Real allowed = kAllowedRoundings<T> * roundingOf(shape, ray);
    EXPECT_TRUE(contains(cell, clipped));
    EXPECT_TRUE(contains(shape.bounds(), clipped));
    for (const HitOf<TypeParam>& hit : allHits(shape, ray)) {
      const Vec3l point = pointAt(shape, ray, hit.t);
      // The point is not quite on the surface: next to a side of the cell that may be outside.
      if (excess(cell, shape, point) > -allowed)
        continue;
      EXPECT_LE(excess(clipped, shape, point), allowed);
    }
  });
}

/// The shapes with an inside: `level` is defined for them.
template <class S>
class SolidShape : public ::testing::Test {};
using SolidShapeTypes =
    ::testing::Types<Sphere<float>, Sphere<double>, Box<float>, Box<double>, Cylinder<float>,
                     Cylinder<double>, Cone<float>, Cone<double>>;
TYPED_TEST_SUITE(SolidShape, SolidShapeTypes);

template <class S>
[[nodiscard]] S closed(S shape) {
  if constexpr (requires { shape.capped; })
    shape.capped = true;
  return shape;
}

TYPED_TEST(SolidShape, IsHitTwiceByLinesThroughItAndElseNever) {
  int throughCount = 0;
  int besideCount = 0;
  forRandomRays<TypeParam>([&](const TypeParam& shape, const RayOf<TypeParam>& ray) {
    const TypeParam solid = closed(shape);
    const Real allowed = kAllowedRoundings<typename TypeParam::Scalar> * roundingOf(solid, ray);
    const auto [deepest, t] = deepestPoint(solid, ray);
    const std::vector<HitOf<TypeParam>> hits = allHits(solid, ray);
    if (deepest < -allowed) {
      ++throughCount;
      ASSERT_EQ(hits.size(), 2u) << "the line passes " << -deepest / allowed
                                 << " below the surface";
      EXPECT_LT(hits[0].t, t);
      EXPECT_GT(hits[1].t, t);
      EXPECT_LE(dot(Vec3d(hits[0].normal), normalized(Vec3d(ray.direction))), 1e-6);
      EXPECT_GE(dot(Vec3d(hits[1].normal), normalized(Vec3d(ray.direction))), -1e-6);
    } else if (deepest > allowed) {
      ++besideCount;
      EXPECT_TRUE(hits.empty()) << "the line passes at " << deepest / allowed;
    } else {
      EXPECT_LE(hits.size(), 2u);
    }
  });
  EXPECT_GT(throughCount, kShapeCount * kRaysPerShape / 3);
  EXPECT_GT(besideCount, kShapeCount * kRaysPerShape / 40);
}

TYPED_TEST(SolidShape, LetsNoRayOutFromInside) {
  using T = typename TypeParam::Scalar;
  int insideCount = 0;
  forRandomRays<TypeParam>([&](const TypeParam& shape, const RayOf<TypeParam>& ray) {
    const TypeParam solid = closed(shape);
    const Real allowed = kAllowedRoundings<T> * roundingOf(solid, ray);
    if (level(solid, pointAt(solid, ray, Real(0))) > -allowed)
      return;
    ++insideCount;
    EXPECT_EQ(allHits(solid, ray, T(0)).size(), 1u);
    EXPECT_EQ(allHits(solid, ray).size(), 2u);
  });
  EXPECT_GT(insideCount, kShapeCount * kRaysPerShape / 40);
}

TYPED_TEST(SolidShape, NormalsPointOutward) {
  forRandomRays<TypeParam>([&](const TypeParam& shape, const RayOf<TypeParam>& ray) {
    const TypeParam solid = closed(shape);
    // The level is convex, so along its gradient it rises at least as fast as at the surface.
    const Real step = length(Vec3l(solid.bounds().size()));
    if (roundingOf(solid, ray) > 0x1p-17 * step)
      return;
    for (const HitOf<TypeParam>& hit : allHits(solid, ray)) {
      const Vec3l point = pointAt(solid, ray, hit.t);
      const Real outside = level(solid, point + Vec3l(hit.normal) * step);
      EXPECT_GE(outside, 0.99 * step) << "part " << hit.part;
    }
  });
}

template <class S>
class TubeShape : public ::testing::Test {};
using TubeShapeTypes =
    ::testing::Types<Cylinder<float>, Cylinder<double>, Cone<float>, Cone<double>>;
TYPED_TEST_SUITE(TubeShape, TubeShapeTypes);

TYPED_TEST(TubeShape, WithoutCapsHasTheSideHitsOfTheSolid) {
  int comparedCount = 0;
  forRandomRays<TypeParam>([&](TypeParam shape, const RayOf<TypeParam>& ray) {
    const Real allowed = kAllowedRoundings<typename TypeParam::Scalar> * roundingOf(shape, ray);
    shape.capped = true;
    std::vector<HitOf<TypeParam>> solidHits = allHits(shape, ray);
    shape.capped = false;
    const std::vector<HitOf<TypeParam>> openHits = allHits(shape, ray);

    // Where the line touches the solid, or a rim, rounding decides what it hits: in double, and all
    // the farther from the rim the less side and cap differ in direction.
    constexpr Real kLeastAngle = 0x1p-18;
    const Real rounding =
        kUnitRoundoff<double> * largestDistance(ray.origin, shape.bounds()) / kLeastAngle;
    const auto isNearRim = [&](const HitOf<TypeParam>& hit) {
      return rimDistance(shape, pointAt(shape, ray, hit.t)) < allowed + rounding;
    };
    if (deepestPoint(shape, ray).level > -allowed)
      return;
    if (std::any_of(solidHits.begin(), solidHits.end(), isNearRim))
      return;
    if (std::any_of(openHits.begin(), openHits.end(), isNearRim))
      return;
    ++comparedCount;
    std::erase_if(solidHits, [](const auto& hit) { return hit.part != kSidePart; });
    EXPECT_EQ(openHits.size(), solidHits.size());
  });
  EXPECT_GT(comparedCount, kShapeCount * kRaysPerShape / 4);
}

template <class S>
class SquareShape : public ::testing::Test {};
using SquareShapeTypes = ::testing::Types<Square<float>, Square<double>>;
TYPED_TEST_SUITE(SquareShape, SquareShapeTypes);

TYPED_TEST(SquareShape, IsHitWhereTheLineMeetsItsPlaneWithinTheEdges) {
  using T = typename TypeParam::Scalar;
  forRandomRays<TypeParam>([&](const TypeParam& square, const RayOf<TypeParam>& ray) {
    const Vec3l origin = squareCoordinates(square, pointAt(square, ray, Real(0)));
    const Vec3l direction = squareCoordinates(square, Vec3l(ray.direction));
    const Real steepness = std::fabs(direction.z) / length(Vec3l(ray.direction));
    if (steepness < 1e-3)
      return;
    const Real t = -origin.z / direction.z;
    const Real beyondEdge =
        std::max(std::fabs(origin.x + t * direction.x), std::fabs(origin.y + t * direction.y)) -
        Real(0.5);
    const Vec3l edgeU(square.edgeU);
    const Vec3l edgeV(square.edgeV);
    const Real height = length(cross(edgeU, edgeV)) / std::max(length(edgeU), length(edgeV));
    const Real allowed = 2 * kAllowedRoundings<T> * roundingOf(square, ray) / steepness / height;
    const std::vector<HitOf<TypeParam>> hits = allHits(square, ray);
    if (beyondEdge < -allowed) {
      ASSERT_EQ(hits.size(), 1u);
      EXPECT_NEAR(static_cast<double>(hits[0].u - 0.5 - (origin.x + t * direction.x)), 0.0,
                  static_cast<double>(allowed));
      EXPECT_NEAR(static_cast<double>(hits[0].v - 0.5 - (origin.y + t * direction.y)), 0.0,
                  static_cast<double>(allowed));
    } else if (beyondEdge > allowed) {
      EXPECT_TRUE(hits.empty());
    }
  });
}

}  // namespace
}  // namespace planetree::test
