#include <planetree/node/node.hpp>
#include <planetree/traversal/order_children.hpp>

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace planetree {
namespace {

template <class T>
class OrderChildren : public testing::Test {
 protected:
  static constexpr Box3 kBounds{{-1, -1, -1}, {1, 1, 1}};
  // A split at x = 0 with two empty leaves.
  std::array<Node, 3> nodes_ = {SplitNode(Axis::X, 0.0f, 2), LeafNode(0, 0), LeafNode(0, 0)};

  ChildOrder<T> order(const Vec3<T>& origin, const Vec3<T>& direction,
                      const Interval<T>& interval = {T(0), T(100)}) {
    return orderChildren(nodes_[0].split(), PreparedRay<T>({origin, direction}, kBounds), interval);
  }
  const Node* left() const { return &nodes_[1]; }
  const Node* right() const { return &nodes_[2]; }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(OrderChildren, Scalars);

TYPED_TEST(OrderChildren, TakesNearAndFarFromTheSignOfTheDirection) {
  const auto rising = this->order({-2, 0, 0}, {1, 0, 0});
  EXPECT_EQ(rising.near, this->left());
  EXPECT_EQ(rising.far, this->right());
  const auto falling = this->order({2, 0, 0}, {-1, 0, 0});
  EXPECT_EQ(falling.near, this->right());
  EXPECT_EQ(falling.far, this->left());
}

TYPED_TEST(OrderChildren, SplitsTheIntervalAtThePlaneWithAnOverlap) {
  const auto order = this->order({-2, 0, 0}, {1, 0, 0});
  ASSERT_TRUE(order.visitsNear && order.visitsFar);
  EXPECT_GT(order.nearPart.tMax, TypeParam(2));
  EXPECT_LT(order.farPart.tMin, TypeParam(2));
  EXPECT_NEAR(static_cast<double>(order.nearPart.tMax), 2.0, 1e-4);
  EXPECT_NEAR(static_cast<double>(order.farPart.tMin), 2.0, 1e-4);
  EXPECT_EQ(order.nearPart.tMin, TypeParam(0));
  EXPECT_EQ(order.farPart.tMax, TypeParam(100));
}

TYPED_TEST(OrderChildren, VisitsOnlyTheSideThatTheIntervalReaches) {
  const auto before = this->order({-2, 0, 0}, {1, 0, 0}, {TypeParam(0), TypeParam(1)});
  EXPECT_TRUE(before.visitsNear);
  EXPECT_FALSE(before.visitsFar);
  const auto behind = this->order({-2, 0, 0}, {1, 0, 0}, {TypeParam(3), TypeParam(4)});
  EXPECT_FALSE(behind.visitsNear);
  EXPECT_TRUE(behind.visitsFar);
}

TYPED_TEST(OrderChildren, VisitsBothOverTheWholeIntervalForARayInThePlane) {
  for (const TypeParam zero : {TypeParam(0), TypeParam(-0.0)}) {
    const auto order = this->order({zero, -2, 0}, {zero, 1, 0});
    EXPECT_TRUE(order.visitsNear);
    EXPECT_TRUE(order.visitsFar);
    EXPECT_EQ(order.nearPart.tMin, TypeParam(0));
    EXPECT_GE(order.nearPart.tMax, TypeParam(3));
    EXPECT_LE(order.farPart.tMin, TypeParam(0));
  }
}

TYPED_TEST(OrderChildren, VisitsOnlyTheSideThatAParallelRayRunsIn) {
  for (const TypeParam zero : {TypeParam(0), TypeParam(-0.0)}) {
    const auto below = this->order({TypeParam(-0.5), -2, 0}, {zero, 1, 0});
    EXPECT_NE(below.visitsNear, below.visitsFar);
    EXPECT_EQ(below.visitsNear ? below.near : below.far, this->left());
    const auto above = this->order({TypeParam(0.5), -2, 0}, {zero, 1, 0});
    EXPECT_NE(above.visitsNear, above.visitsFar);
    EXPECT_EQ(above.visitsNear ? above.near : above.far, this->right());
  }
}

TYPED_TEST(OrderChildren, AlwaysVisitsAtLeastOneSide) {
  for (const TypeParam t : {TypeParam(0), TypeParam(1), TypeParam(2), TypeParam(3)}) {
    const auto order = this->order({-2, 0, 0}, {1, 0, 0}, {t, t});
    EXPECT_TRUE(order.visitsNear || order.visitsFar) << t;
  }
}

TYPED_TEST(OrderChildren, VisitsBothSidesIfTheDistanceIsNotANumber) {
  const TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
  const auto order = this->order({nan, 0, 0}, {1, 0, 0});
  EXPECT_TRUE(order.visitsNear);
  EXPECT_TRUE(order.visitsFar);
  EXPECT_EQ(order.nearPart.tMax, TypeParam(100));
  EXPECT_EQ(order.farPart.tMin, TypeParam(0));
}

TYPED_TEST(OrderChildren, ClipsARayToABoxNeverTooShort) {
  const Box3 bounds{{-1, -1, -1}, {1, 1, 1}};
  const PreparedRay<TypeParam> ray({{-3, 0, 0}, {1, 0, 0}}, bounds);
  const Interval<TypeParam> inside = ray.clip(bounds, {0, std::numeric_limits<TypeParam>::max()});
  EXPECT_LE(inside.tMin, TypeParam(2));
  EXPECT_GE(inside.tMax, TypeParam(4));
  EXPECT_NEAR(static_cast<double>(inside.tMin), 2.0, 1e-4);
  EXPECT_NEAR(static_cast<double>(inside.tMax), 4.0, 1e-4);
  const PreparedRay<TypeParam> beside({{-3, 2, 0}, {1, 0, 0}}, bounds);
  EXPECT_TRUE(beside.clip(bounds, {0, std::numeric_limits<TypeParam>::max()}).isEmpty());
}

}  // namespace
}  // namespace planetree
