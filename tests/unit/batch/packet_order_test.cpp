#include "batch/packet_order.hpp"

#include <planetree/geometry/vec3.hpp>

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace planetree::detail {
namespace {

constexpr Box3 kBounds{{-1, -1, -1}, {1, 1, 1}};

/// Rays of a camera, row by row.
std::vector<Rayf> pictureRays(std::size_t width, std::size_t height) {
  std::vector<Rayf> rays;
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const Vec3d direction{(static_cast<double>(x) + 0.5) / static_cast<double>(width) - 0.5,
                            0.5 - (static_cast<double>(y) + 0.5) / static_cast<double>(width),
                            -1.0};
      rays.push_back({.origin = {0, 0, 3}, .direction = static_cast<Vec3f>(normalized(direction))});
    }
  }
  return rays;
}

PacketOrder orderOf(const std::vector<Rayf>& rays) {
  return PacketOrder(RayColumns<float>(std::span<const Rayf>(rays)), kBounds);
}

void expectEachRayOnce(const PacketOrder& order, std::size_t rayCount) {
  std::vector<int> seen(rayCount, 0);
  for (std::size_t packet = 0; packet < order.packetCount(); ++packet) {
    const PacketOrder::Place place = order[packet];
    EXPECT_GE(place.count, 1u);
    for (std::size_t i = 0; i < place.count; ++i)
      ++seen.at(place.rays[i]);
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(rayCount));
}

TEST(PacketOrder, FindsTheWidthOfPictures) {
  for (const auto& [width, height] :
       {std::pair<std::size_t, std::size_t>{64, 48}, {100, 37}, {8, 4}, {33, 5}, {1024, 9}}) {
    SCOPED_TRACE(width);
    const std::vector<Rayf> rays = pictureRays(width, height);
    const PacketOrder order = orderOf(rays);
    EXPECT_EQ(order.width(), width);
    expectEachRayOnce(order, rays.size());
  }
}

TEST(PacketOrder, TakesSquaresOfAPicture) {
  const std::vector<Rayf> rays = pictureRays(64, 48);
  const PacketOrder::Place place = orderOf(rays)[17];
  ASSERT_EQ(place.count, 16u);
  for (std::size_t i = 0; i < place.count; ++i)
    EXPECT_EQ(place.rays[i], (4 + i / 4) * 64 + 4 + i % 4);
}

TEST(PacketOrder, TakesOtherRaysAsTheyCome) {
  test::Random random(3);
  std::vector<Rayf> scattered(1000);
  for (Rayf& ray : scattered) {
    ray.origin = random.pointIn<float>({-1, -1, -1}, {1, 1, 1});
    ray.direction = static_cast<Vec3f>(random.direction());
  }
  std::vector<Rayf> cut = pictureRays(64, 48);
  cut.pop_back();
  const std::vector<Rayf> equal(200, cut.front());
  std::vector<Rayf> withoutNumbers = pictureRays(64, 48);
  withoutNumbers[5].direction.x = std::numeric_limits<float>::quiet_NaN();
  for (const std::vector<Rayf>& rays :
       {scattered, cut, equal, withoutNumbers, pictureRays(7, 40), pictureRays(40, 3),
        std::vector<Rayf>(), std::vector<Rayf>(1)}) {
    SCOPED_TRACE(rays.size());
    const PacketOrder order = orderOf(rays);
    EXPECT_EQ(order.width(), 0u);
    EXPECT_EQ(order.packetCount(), (rays.size() + 15) / 16);
    expectEachRayOnce(order, rays.size());
  }
}

}  // namespace
}  // namespace planetree::detail
