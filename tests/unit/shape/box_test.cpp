#include "support/random.hpp"
#include "unit/shape/shape_checks.hpp"

#include <planetree/shape/box.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace planetree::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(Box, IsHitWhereTheRayEntersAndLeaves) {
  const Box<double> box;
  const auto hits = allHits(box, Rayd{{0.25, -0.25, 3}, {0, 0, -2}});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].t, 1.25);
  EXPECT_EQ(hits[0].normal, (Vec3d{0, 0, 1}));
  EXPECT_EQ(hits[1].t, 1.75);
  EXPECT_EQ(hits[1].normal, (Vec3d{0, 0, -1}));
}

TEST(Box, NamesItsSides) {
  const Box<float> box;
  for (const Axis axis : kAxes) {
    for (const bool isUpper : {false, true}) {
      Rayf ray{{0.25f, 0.25f, 0.25f}, {0, 0, 0}};
      ray.direction[axis] = isUpper ? 1.0f : -1.0f;
      const auto hit = box.intersect(ray, 0.0f, kInfinity);
      ASSERT_TRUE(hit);
      EXPECT_EQ(hit->part, 2u * static_cast<unsigned>(axis) + (isUpper ? 1u : 0u));
      EXPECT_EQ(hit->normal, ray.direction);
    }
  }
}

TEST(Box, TellsThePositionOnTheSide) {
  const Box<double> box{{0, 10, 100}, {1, 20, 200}};
  const auto onX = box.intersect({{-1, 12, 170}, {1, 0, 0}}, 0.0, 10.0);
  EXPECT_DOUBLE_EQ(onX->u, 0.2);
  EXPECT_DOUBLE_EQ(onX->v, 0.7);
  const auto onY = box.intersect({{0.25, 0, 170}, {0, 1, 0}}, 0.0, 100.0);
  EXPECT_DOUBLE_EQ(onY->u, 0.7);
  EXPECT_DOUBLE_EQ(onY->v, 0.25);
  const auto onZ = box.intersect({{0.25, 12, 0}, {0, 0, 1}}, 0.0, 1000.0);
  EXPECT_DOUBLE_EQ(onZ->u, 0.25);
  EXPECT_DOUBLE_EQ(onZ->v, 0.2);
}

TEST(Box, IsHitOnceThroughAnEdgeOrACorner) {
  const Box<double> box{{0, 0, 0}, {1, 1, 1}};
  const auto onEdge = allHits(box, Rayd{{-1, 1, 0.5}, {1, 1, 0}});
  EXPECT_TRUE(onEdge.empty());
  const auto throughEdge = allHits(box, Rayd{{-1, 0, 0.5}, {1, 1, 0}});
  ASSERT_EQ(throughEdge.size(), 1u);
  EXPECT_EQ(throughEdge[0].t, 1.0);
  const auto throughCorner = allHits(box, Rayd{{2, 2, 2}, {-1, -1, -1}});
  ASSERT_EQ(throughCorner.size(), 2u);
  EXPECT_EQ(throughCorner[0].part, 1u) << "of equal sides the one of the lowest axis counts";
}

TEST(Box, HitsRaysThatRunInItsSides) {
  const Box<float> box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(allHits(box, Rayf{{-1, 1, 0.5}, {1, 0, 0}}).size(), 2u);
  EXPECT_EQ(allHits(box, Rayf{{-1, 1, 1}, {1, -0.0f, -0.0f}}).size(), 2u);
  EXPECT_TRUE(allHits(box, Rayf{{-1, nextUp(1.0f), 0.5}, {1, 0, 0}}).empty());
}

TEST(Box, MayBeFlat) {
  const Box<double> sheet{{0, 0, 2}, {1, 1, 2}};
  const auto hits = allHits(sheet, Rayd{{0.5, 0.5, 0}, {0, 0, 1}});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].t, 2.0);
  EXPECT_EQ(hits[0].part, 4u);
  EXPECT_EQ(sheet.bounds(), (Box3{{0, 0, 2}, {1, 1, 2}}));
  const Box<double> point{{1, 1, 1}, {1, 1, 1}};
  EXPECT_EQ(allHits(point, Rayd{{0, 0, 0}, {1, 1, 1}}).size(), 1u);
}

TEST(Box, TurnedInsideOutIsNothing) {
  const Box<float> box{{0, 1, 0}, {1, 0, 1}};
  EXPECT_EQ(box.bounds(), Box3{});
  EXPECT_TRUE(box.clippedBounds({{-9, -9, -9}, {9, 9, 9}}).isEmpty());
  EXPECT_TRUE(allHits(box, Rayf{{0.5, 0.5, -1}, {0, 0, 1}}).empty());
}

TEST(Box, WithMembersThatAreNotFiniteIsNothing) {
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (const Box<float>& box : {Box<float>{{bad, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {1, 1, bad}}}) {
      EXPECT_FALSE(isFinite(box.bounds().lower));
      EXPECT_TRUE(box.clippedBounds({{-9, -9, -9}, {9, 9, 9}}).isEmpty());
      EXPECT_TRUE(allHits(box, Rayf{{0.5, 0.5, -1}, {0, 0, 1}}).empty());
    }
  }
}

TEST(Box, IsAbsentFromCellsWithinIt) {
  const Box<double> box{{0, 0, 0}, {4, 4, 4}};
  EXPECT_TRUE(box.clippedBounds({{1, 1, 1}, {3, 3, 3}}).isEmpty());
  EXPECT_EQ(box.clippedBounds({{1, 1, 1}, {3, 3, 4}}), (Box3{{1, 1, 4}, {3, 3, 4}}));
  EXPECT_EQ(box.clippedBounds({{1, 1, 1}, {3, 3, 9}}), (Box3{{1, 1, 4}, {3, 3, 4}}));
  EXPECT_EQ(box.clippedBounds({{-1, -1, -1}, {9, 9, 9}}), box.bounds());
  EXPECT_TRUE(box.clippedBounds({{5, 5, 5}, {6, 6, 6}}).isEmpty());
}

template <class T>
class BoxGrid : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(BoxGrid, Scalars);

TYPED_TEST(BoxGrid, LetsNoRayThroughBetweenBoxes) {
  using T = TypeParam;
  constexpr std::size_t kCount = 4;
  SCOPED_TRACE(describeSeed());
  Random random;
  // Planes that no sum of equal steps gives, so that every t is rounded.
  std::vector<T> planes = {T(0)};
  for (std::size_t i = 0; i < kCount; ++i) {
    planes.push_back(planes.back() + static_cast<T>(random.between(0.1, 1.0)));
  }
  std::vector<Box<T>> grid;
  for (std::size_t i = 0; i < kCount * kCount; ++i) {
    const std::size_t x = i % kCount;
    const std::size_t y = i / kCount;
    grid.push_back({{planes[x], planes[y], T(0)}, {planes[x + 1], planes[y + 1], T(0.3)}});
  }
  for (int i = 0; i < 20000; ++i) {
    // From above onto an inner edge or corner of the grid, as nearly as rounding lets a ray aim.
    const Vec3<T> aim = {planes[1 + random.below(kCount - 1)],
                         random.chance(0.5) ? planes[1 + random.below(kCount - 1)]
                                            : static_cast<T>(random.between(0.1, 0.4)),
                         T(0.3)};
    const Vec3<T> eye = random.pointIn<T>({-1, -1, 1}, {2, 2, 3});
    const Ray<T> ray{eye, aim - eye};
    T nearest = std::numeric_limits<T>::infinity();
    for (const Box<T>& box : grid) {
      const auto hit = box.intersect(ray, T(0), nearest);
      if (hit)
        nearest = hit->t;
    }
    ASSERT_NEAR(nearest, T(1), 16 * std::numeric_limits<T>::epsilon()) << "ray " << i;
  }
}

}  // namespace
}  // namespace planetree::test
