#include <planetree/hit/hit.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace planetree {
namespace {

template <class T>
class HitTest : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(HitTest, Scalars);

TYPED_TEST(HitTest, IsAMissWhenDefaultMade) {
  const Hit<TypeParam> miss;
  EXPECT_EQ(miss.t, std::numeric_limits<TypeParam>::infinity());
  EXPECT_EQ(miss.geometry, kNoId);
  EXPECT_EQ(miss.primitive, kNoId);
}

TYPED_TEST(HitTest, IsOrderedByDistanceThenGeometryThenPrimitiveThenPart) {
  using H = Hit<TypeParam>;
  const std::array<H, 6> inOrder = {H{.t = -1, .geometry = 9, .primitive = 9, .part = 9},
                                    H{.t = 1, .geometry = 0, .primitive = 9, .part = 9},
                                    H{.t = 1, .geometry = 1, .primitive = 2, .part = 9},
                                    H{.t = 1, .geometry = 1, .primitive = 3, .part = 0},
                                    H{.t = 1, .geometry = 1, .primitive = 3, .part = 1},
                                    H{}};
  for (std::size_t i = 0; i < inOrder.size(); ++i) {
    for (std::size_t j = 0; j < inOrder.size(); ++j) {
      EXPECT_EQ(isBefore(inOrder[i], inOrder[j]), i < j) << i << ", " << j;
    }
  }
}

TYPED_TEST(HitTest, TakesBothZerosForTheSameDistance) {
  const Hit<TypeParam> positive{.t = TypeParam(0), .geometry = 0, .primitive = 1};
  const Hit<TypeParam> negative{.t = TypeParam(-0.0), .geometry = 0, .primitive = 2};
  EXPECT_TRUE(isBefore(positive, negative));
  EXPECT_FALSE(isBefore(negative, positive));
}

}  // namespace
}  // namespace planetree
