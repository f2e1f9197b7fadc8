#pragma once

#include <planetree/geometry/box3.hpp>

#include "batch/columns.hpp"
#include "traversal/ray_packet.hpp"

#include <algorithm>
#include <cstddef>

namespace planetree::detail {

/// Which rays of a batch make a packet. Rays in the order of the pixels of a picture, row by row,
/// are taken in squares of four by four, which have more in common than sixteen of a row; other
/// rays as they come.
class PacketOrder {
 public:
  /// The rays of one packet: `rows` times `columns` of them.
  struct Place {
    std::size_t first = 0;
    std::size_t rows = 1;
    std::size_t columns = 0;
    std::size_t width = 0;  ///< from a row to the next

    [[nodiscard]] std::size_t size() const noexcept { return rows * columns; }
    [[nodiscard]] std::size_t ray(std::size_t i) const noexcept {
      return first + i / columns * width + i % columns;
    }
  };

  /// Finds out how wide the picture is, if it is one; `bounds` are those of the tree.
  template <class T>
  PacketOrder(const RayColumns<T>& rays, const Box3& bounds) noexcept;

  [[nodiscard]] std::size_t packetCount() const noexcept { return packetCount_; }
  [[nodiscard]] Place operator[](std::size_t packet) const noexcept {
    if (width_ == 0) {
      const std::size_t first = packet * RayPacket::kRayCount;
      return {.first = first, .columns = std::min(RayPacket::kRayCount, rayCount_ - first)};
    }
    const std::size_t row = packet / packetsPerRow_ * kSide;
    const std::size_t column = packet % packetsPerRow_ * kSide;
    return {.first = row * width_ + column,
            .rows = std::min(kSide, rayCount_ / width_ - row),
            .columns = std::min(kSide, width_ - column),
            .width = width_};
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
