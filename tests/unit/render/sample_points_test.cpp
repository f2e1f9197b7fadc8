#include "render/sample_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

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
      for (const Point2& direction : point.directions)
        EXPECT_TRUE(isInUnitSquare(direction));
    }
  }
}

/// Every cell of a grid of columns x rows, as many cells as points, holds one point.
void expectOnePointPerCell(const std::vector<Point2>& points, std::size_t columns) {
  const std::size_t rows = points.size() / columns;
  std::set<std::pair<int, int>> cells;
  for (const Point2& point : points) {
    cells.emplace(static_cast<int>(point.x * static_cast<double>(columns)),
                  static_cast<int>(point.y * static_cast<double>(rows)));
  }
  EXPECT_EQ(cells.size(), points.size()) << columns << " x " << rows;
}

TEST(SamplePoints, OfAPixelFillEveryGridOfAPowerOfTwo) {
  constexpr std::uint32_t kSamples = 16;
  for (const std::uint64_t seed : {0u, 1u, 99u}) {
    const SamplePoints points(kSamples, seed);
    for (const auto& [x, y] : {std::pair{0u, 0u}, {1u, 0u}, {2u, 5u}, {797u, 599u}}) {
      SCOPED_TRACE(testing::Message() << "pixel " << x << ", " << y << ", seed " << seed);
      std::vector<Point2> film;
      std::vector<Point2> directions;
      for (std::uint32_t i = 0; i < kSamples; ++i) {
        const SamplePoint point = points.at(x, y, i);
        film.push_back(point.film);
        directions.insert(directions.end(), point.directions.begin(), point.directions.end());
      }
      for (const std::size_t columns : {1u, 2u, 4u, 8u, 16u}) {
        expectOnePointPerCell(film, columns);
        expectOnePointPerCell(directions, columns);
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
  EXPECT_NE(point.directions[0].x, point.film.x);
}

TEST(CosineDistributed, HasUnitDirectionsInTheHemisphereOfTheNormal) {
  const SamplePoints points(256, 7);
  for (const Vec3f& normal :
       {Vec3f{0.0f, 0.0f, 1.0f}, Vec3f{0.0f, 0.0f, -1.0f}, Vec3f{1.0f, 0.0f, 0.0f},
        Vec3f{0.0f, -1.0f, 0.0f}, normalized(Vec3f{1.0f, -2.0f, 3.0f}),
        normalized(Vec3f{1e-4f, 1e-4f, -1.0f})}) {
    Vec3d sum;
    for (std::uint32_t i = 0; i < 256; ++i) {
      const Vec3f direction = cosineDistributed(normal, points.at(0, 0, i).film);
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
