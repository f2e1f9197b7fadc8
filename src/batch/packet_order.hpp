#pragma once

#include <planetree/geometry/box3.hpp>

#include "batch/columns.hpp"
#include "traversal/ray_packet.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace planetree::detail {

/// Which rays of a batch make a packet. Rays in the order of the pixels of a picture, row by row,
/// are taken in squares of four by four, which have more in common than sixteen of a row; other
/// rays as they come.
class PacketOrder {
 public:
  /// The rays of one packet.
  struct Place {
    std::array<std::size_t, RayPacket::kRayCount> rays;
    std::size_t count = 0;
  };

  /// Finds out how wide the picture is, if it is one; `bounds` are those of the tree.
  template <class T>
  PacketOrder(const RayColumns<T>& rays, const Box3& bounds) noexcept;

  [[nodiscard]] std::size_t packetCount() const noexcept { return packetCount_; }
  [[nodiscard]] Place operator[](std::size_t packet) const noexcept {
    Place place;
    if (width_ == 0) {
      const std::size_t first = packet * RayPacket::kRayCount;
      place.count = std::min(RayPacket::kRayCount, rayCount_ - first);
      for (std::size_t i = 0; i < RayPacket::kRayCount; ++i)
        place.rays[i] = first + i;
      return place;
    }
    const std::size_t firstRow = packet / packetsPerRow_ * kSide;
    const std::size_t column = packet % packetsPerRow_ * kSide;
    const std::size_t rowCount = std::min(kSide, rayCount_ / width_ - firstRow);
    const std::size_t columnCount = std::min(kSide, width_ - column);
    for (std::size_t row = firstRow; row < firstRow + rowCount; ++row) {
      for (std::size_t i = 0; i < columnCount; ++i)
        place.rays[place.count++] = row * width_ + column + i;
    }
    return place;
  }

  /// 0 if the rays are not those of a picture.
  [[nodiscard]] std::size_t width() const noexcept { return width_; }

 private:
  static constexpr std::size_t kSide = 4;
  static_assert(kSide * kSide == RayPacket::kRayCount);

  std::size_t rayCount_;
  std::size_t width_ = 0;
  std::size_t packetsPerRow_ = 0;
  std::size_t packetCount_;
};

}  // namespace planetree::detail
