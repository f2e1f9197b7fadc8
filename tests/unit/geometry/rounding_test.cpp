#include "support/random.hpp"

#include <planetree/geometry/rounding.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace planetree::test {
namespace {

constexpr float kMax = std::numeric_limits<float>::max();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(NextUp, IsTheNextNumber) {
  EXPECT_EQ(nextUp(1.0f), 1.0f + 0x1p-23f);
  EXPECT_EQ(nextUp(1.0), 1.0 + 0x1p-52);
  EXPECT_EQ(nextUp(-1.0f), -1.0f + 0x1p-24f);
  EXPECT_EQ(nextUp(0.0f), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(nextUp(-0.0f), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(nextUp(kMax), kInfinity);
  EXPECT_EQ(nextUp(-kInfinity), -kMax);
  EXPECT_EQ(nextUp(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(nextUp(std::numeric_limits<float>::quiet_NaN())));
}

TEST(NextDown, UndoesNextUp) {
  for (const double x : {1.0, -1.0, 1e-300, -1e300, 0.1, 5e-324}) {
    EXPECT_EQ(nextDown(nextUp(x)), x);
    EXPECT_LT(nextDown(x), x);
  }
  EXPECT_EQ(nextDown(-kInfinity), -kInfinity);
}

TEST(RoundToFloat, KeepsFloats) {
  for (const float x : {0.0f, 1.0f, -0.1f, kMax, -kMax, 1e-45f, kInfinity, -kInfinity}) {
    EXPECT_EQ(roundDown(static_cast<double>(x)), x);
    EXPECT_EQ(roundUp(static_cast<double>(x)), x);
  }
}

TEST(RoundToFloat, EnclosesWithinOneStep) {
  SCOPED_TRACE(describeSeed());
  Random random;
  for (int i = 0; i < 10000; ++i) {
    const double x = random.between(-1.0, 1.0) * std::exp2(random.between(-140.0, 127.0));
    const float below = roundDown(x);
    const float above = roundUp(x);
    EXPECT_LE(static_cast<double>(below), x);
    EXPECT_GE(static_cast<double>(above), x);
    EXPECT_TRUE(above == below || above == nextUp(below)) << x;
  }
}

TEST(RoundToFloat, EnclosesWhatFloatCannotHold) {
  EXPECT_EQ(roundDown(1e-100), 0.0f);
  EXPECT_EQ(roundUp(1e-100), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(roundDown(-1e-100), -std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(roundDown(1e300), kMax);
  EXPECT_EQ(roundUp(1e300), kInfinity);
  EXPECT_EQ(roundUp(-1e300), -kMax);
  EXPECT_EQ(roundDown(-1e300), -kInfinity);
  EXPECT_TRUE(std::isnan(roundDown(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(roundUp(std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace planetree::test
