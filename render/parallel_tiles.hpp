#pragma once

#include "render/image.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

namespace planetree::render {

/// Part of a picture.
struct Tile {
  std::uint32_t firstX = 0;
  std::uint32_t endX = 0;
  std::uint32_t firstY = 0;
  std::uint32_t endY = 0;
};

/// Side of the square tiles that threads take on. Small enough to share the work evenly, large
/// enough that the rays of a tile find the nodes they need in the cache.
inline constexpr std::uint32_t kTileSide = 16;

/// Calls `visit` once for each of the tiles that make up a picture, from several threads; 0 is as
/// many as the machine has.
void forEachTile(const ImageSize& size, std::uint32_t threadCount,
                 const std::function<void(const Tile&)>& visit, std::uint32_t side = kTileSide);

/// Counts work that many threads do, tells how much of it is done, and asks whether to go on.
class Progress {
 public:
  /// `keepsGoing` may be empty; else it is called by any thread, and several at once.
  Progress(std::function<bool(double done)> keepsGoing, std::size_t total)
      : keepsGoing_(std::move(keepsGoing)), total_(total) {}

  void add(std::size_t count) {
    const std::size_t done = done_ += count;
    if (keepsGoing_ && !keepsGoing_(static_cast<double>(done) / static_cast<double>(total_)))
      isStopped_ = true;
  }

  /// Corrects how much work there is in all; not while others call `add`.
  void setTotal(std::size_t total) noexcept { total_ = total; }

  /// The part of the work that is done, from 0 to 1.
  [[nodiscard]] double done() const noexcept {
    return total_ == 0 ? 1.0 : static_cast<double>(done_) / static_cast<double>(total_);
  }

  [[nodiscard]] bool isStopped() const noexcept { return isStopped_; }

 private:
  std::function<bool(double)> keepsGoing_;
  std::atomic<std::size_t> total_;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> isStopped_ = false;
};

}  // namespace planetree::render
