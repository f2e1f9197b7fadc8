#include <planetree/geometry/vec3.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace planetree {
namespace {

TEST(Vec3, IsThreeScalarsWithoutPadding) {
  static_assert(sizeof(Vec3f) == 3 * sizeof(float) && sizeof(Vec3d) == 3 * sizeof(double));
  static_assert(std::is_standard_layout_v<Vec3f> && std::is_trivially_copyable_v<Vec3f>);
  constexpr Vec3f zero;
  EXPECT_EQ(zero, (Vec3f{0, 0, 0}));
}

TEST(Vec3, IsIndexedByAxis) {
  Vec3d v{1, 2, 3};
  EXPECT_EQ(v[Axis::X], 1.0);
  EXPECT_EQ(v[Axis::Y], 2.0);
  EXPECT_EQ(v[Axis::Z], 3.0);
  v[Axis::Y] = 7.0;
  EXPECT_EQ(v, (Vec3d{1, 7, 3}));
}

TEST(Vec3, ComputesComponentByComponent) {
  constexpr Vec3d a{1, 2, 3};
  constexpr Vec3d b{10, 20, 40};
  static_assert(a + b == Vec3d{11, 22, 43});
  static_assert(b - a == Vec3d{9, 18, 37});
  static_assert(-a == Vec3d{-1, -2, -3});
  static_assert(a * 2.0 == Vec3d{2, 4, 6} && 2.0 * a == a * 2.0);
  static_assert(b / 2.0 == Vec3d{5, 10, 20});
  static_assert(dot(a, b) == 170.0);
}

TEST(Vec3, CrossProductIsRightHanded) {
  constexpr Vec3f x{1, 0, 0};
  constexpr Vec3f y{0, 1, 0};
  constexpr Vec3f z{0, 0, 1};
  static_assert(cross(x, y) == z && cross(y, z) == x && cross(z, x) == y);
  static_assert(cross(y, x) == -z);
}

TEST(Vec3, ConvertsByRoundingToNearest) {
  const Vec3d fine{0.1, 1e-50, 1e10};
  EXPECT_EQ(Vec3f(fine), (Vec3f{0.1f, 0.0f, 1e10f}));
  EXPECT_EQ(Vec3d(Vec3f{0.5f, -2.0f, 3.0f}), (Vec3d{0.5, -2.0, 3.0}));
}

TEST(Normalized, HasLengthOneAtAllScales) {
  for (const float scale : {1e-45f, 1e-38f, 1e-20f, 1.0f, 1e20f, 1e38f}) {
    const Vec3f unit = normalized(Vec3f{scale, -2 * scale, 2 * scale});
    EXPECT_NEAR(length(unit), 1.0f, 4e-7f) << scale;
    EXPECT_NEAR(unit.x, 1.0f / 3.0f, 4e-7f) << scale;
  }
  EXPECT_EQ(normalized(Vec3d{0, 0, -5e-324}), (Vec3d{0, 0, -1}));
}

TEST(Normalized, LeavesZeroAndNonFiniteVectorsAlone) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(normalized(Vec3f{}), Vec3f{});
  EXPECT_EQ(normalized(Vec3f{infinity, 0, 0}), (Vec3f{infinity, 0, 0}));
  EXPECT_TRUE(std::isnan(normalized(Vec3f{nan, nan, nan}).x));
  EXPECT_FALSE(isFinite(normalized(Vec3f{1, nan, 0})));
}

TEST(IsFinite, LooksAtEveryComponent) {
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(isFinite(Vec3f{1, -2, std::numeric_limits<float>::max()}));
  for (const Axis axis : kAxes) {
    for (const float bad : {infinity, -infinity, std::numeric_limits<float>::quiet_NaN()}) {
      Vec3f v{1, 2, 3};
      v[axis] = bad;
      EXPECT_FALSE(isFinite(v));
    }
  }
}

TEST(AxisName, IsALowerCaseLetter) {
  EXPECT_STREQ(axisName(Axis::X), "x");
  EXPECT_STREQ(axisName(Axis::Y), "y");
  EXPECT_STREQ(axisName(Axis::Z), "z");
}

}  // namespace
}  // namespace planetree
