#include "unit/shape/shape_checks.hpp"

#include <planetree/mesh/triangle_mesh.hpp>
#include <planetree/shape/triangle.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace planetree::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Triangle, IsHitFromBothSidesWithOneNormal) {
  const Triangle<double> triangle;
  for (const double side : {-1.0, 1.0}) {
    const auto hits = allHits(triangle, Rayd{{0.25, 0.5, 2 * side}, {0, 0, -side}});
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].t, 2.0);
    EXPECT_EQ(hits[0].u, 0.25);
    EXPECT_EQ(hits[0].v, 0.5);
    EXPECT_EQ(hits[0].normal, (Vec3d{0, 0, 1}));
  }
}

TEST(Triangle, GivesTheHitOfAFaceWithTheSameCorners) {
  const Triangle<float> triangle{{0.1f, 0.2f, 0.3f}, {1.4f, -0.5f, 0.6f}, {0.7f, 1.8f, -0.9f}};
  TriangleMesh<float> mesh;
  mesh.positions = {triangle.a, triangle.b, triangle.c};
  mesh.faces = {{0, 1, 2}};
  const TriangleMeshView<float> view = mesh.view();
  const Rayf ray{{0.5f, 0.4f, 5}, {0.01f, 0.02f, -1}};
  const auto hit = triangle.intersect(ray, 0.0f, kInfinity);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit, view[0].intersect(ray, 0.0f, kInfinity));
  EXPECT_EQ(triangle.bounds(), view[0].bounds());
  for (const Axis axis : kAxes) {
    EXPECT_EQ(triangle.planarSide(axis), view[0].planarSide(axis));
  }
  const Box3 cell{{0, 0, 0}, {0.5, 0.5, 0.5}};
  EXPECT_EQ(triangle.clippedBounds(cell), view[0].clippedBounds(cell));
}

TEST(Triangle, WithTwoEqualCornersIsNothing) {
  const Triangle<float> triangle{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(triangle.bounds(), Box3{});
  EXPECT_TRUE(triangle.clippedBounds({{-9, -9, -9}, {9, 9, 9}}).isEmpty());
  EXPECT_TRUE(allHits(triangle, Rayf{{0.5, 0, 1}, {0, 0, -1}}).empty());
}

TEST(Triangle, WithACornerThatIsNotFiniteIsNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {nan, kInfinity, -kInfinity}) {
    const Triangle<float> triangle{{0, 0, 0}, {1, 0, 0}, {0, bad, 0}};
    EXPECT_FALSE(isFinite(triangle.bounds().lower));
    EXPECT_TRUE(triangle.clippedBounds({{-9, -9, -9}, {9, 9, 9}}).isEmpty());
    EXPECT_TRUE(allHits(triangle, Rayf{{0.1f, 0.1f, 1}, {0, 0, -1}}).empty());
  }
}

}  // namespace
}  // namespace planetree::test
