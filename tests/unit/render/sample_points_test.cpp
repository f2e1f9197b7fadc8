#include "render/sample_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace planetree::render {
namespace {

bool isInUnitSquare(const Point2& point) {
  return point.x >= 0.0 && point.x < 1.0 && point.y >= 0.0 && point.y < 1.0;
}

TEST(SamplePoints, LieInTheUnitSquare) {
  const SamplePoints points(3, 42);
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (const std::uint32_t x : {0u, 17u, 65535u}) {
      const SamplePoint point = points.at(x, 65535u - x, i);
      EXPECT_TRUE(isInUnitSquare(point.film));
      EXPECT_TRUE(isInUnitSquare(point.direction));
    }
  }
}

/// Every cell of a grid of columns x rows, as many cells as points, holds one point.
template <class Choose>
void expectOnePointPerCell(const SamplePoints& points, std::uint32_t x, std::uint32_t y,
                           int columns, int rows, const Choose& choose) {
  std::set<std::pair<int, int>> cells;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(columns * rows); ++i) {
    const Point2 point = choose(points.at(x, y, i));
    cells.emplace(static_cast<int>(point.x * columns), static_cast<int>(point.y * rows));
  }
  EXPECT_EQ(cells.size(), static_cast<std::size_t>(columns * rows))
      << columns << " x " << rows << " at " << x << ", " << y;
}

TEST(SamplePoints, OfAPixelFillEveryGridOfAPowerOfTwo) {
  for (const std::uint64_t seed : {0u, 1u, 99u}) {
    const SamplePoints points(16, seed);
    for (const std::uint32_t x : {0u, 1u, 2u, 797u}) {
      for (const std::uint32_t y : {0u, 5u, 599u}) {
        for (const int columns : {1, 2, 4, 8, 16}) {
          const auto film = [](const SamplePoint& point) { return point.film; };
          const auto direction = [](const SamplePoint& point) { return point.direction; };
          expectOnePointPerCell(points, x, y, columns, 16 / columns, film);
          expectOnePointPerCell(points, x, y, columns, 16 / columns, direction);
        }
      }
    }
  }
}

TEST(SamplePoints, DifferByPixelAndBySeed) {
  const SamplePoint point = SamplePoints(16, 0).at(3, 4, 5);
  EXPECT_EQ(SamplePoints(16, 0).at(3, 4, 5).film.x, point.film.x);
  EXPECT_NE(SamplePoints(16, 0).at(4, 4, 5).film.x, point.film.x);
  EXPECT_NE(SamplePoints(16, 0).at(3, 5, 5).film.x, point.film.x);
  EXPECT_NE(SamplePoints(16, 1).at(3, 4, 5).film.x, point.film.x);
  EXPECT_NE(point.direction.x, point.film.x);
}

TEST(CosineDistributed, HasUnitDirectionsInTheHemisphereOfTheNormal) {
  const SamplePoints points(256, 7);
  for (const Vec3f& normal :
       {Vec3f{0.0f, 0.0f, 1.0f}, Vec3f{0.0f, 0.0f, -1.0f}, Vec3f{1.0f, 0.0f, 0.0f},
        Vec3f{0.0f, -1.0f, 0.0f}, normalized(Vec3f{1.0f, -2.0f, 3.0f}),
        normalized(Vec3f{1e-4f, 1e-4f, -1.0f})}) {
    Vec3d sum;
    for (std::uint32_t i = 0; i < 256; ++i) {
      const Vec3f direction = cosineDistributed(normal, points.at(0, 0, i).direction);
      EXPECT_NEAR(static_cast<double>(length(direction)), 1.0, 1e-6);
      EXPECT_GE(dot(direction, normal), -1e-6f);
      sum = sum + Vec3d(direction);
    }
    // The mean of the cosine under a density proportional to it is 2/3.
    EXPECT_NEAR(dot(sum, Vec3d(normal)) / 256.0, 2.0 / 3.0, 0.01);
    EXPECT_NEAR(length(sum / 256.0), 2.0 / 3.0, 0.01);
  }
}

}  // namespace
}  // namespace planetree::render
