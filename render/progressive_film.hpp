#pragma once

#include "render/film.hpp"
#include "render/parallel_tiles.hpp"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace planetree::render {

/// The sums of a tile while it is rendered, one list for each layer, row by row.
struct TileSums {
  Tile tile;
  std::vector<std::vector<PixelSum>> layers;
};

/// Films that grow sample by sample: the picture, and what else is taken of the same rays. Tiles
/// are worked on apart and put back as a whole, so that whoever looks sees whole tiles.
class ProgressiveFilm {
 public:
  ProgressiveFilm(ImageSize size, std::size_t layerCount);

  [[nodiscard]] const ImageSize& size() const noexcept { return size_; }
  [[nodiscard]] std::size_t layerCount() const noexcept { return layers_.size(); }

  /// A copy of a tile. Any thread may ask, for a tile that nobody else is working on.
  [[nodiscard]] TileSums copyTile(const Tile& tile) const;
  /// Puts it back. Waits only for others that do the same, or that take a copy of a film.
  void commit(const TileSums& sums);

  /// The means of a layer as far as they go, while others may commit. What has no sample is
  /// uncovered.
  [[nodiscard]] Film film(std::size_t layer, const PixelWindow& window) const;

  /// One flag for each pixel, row by row: 1 if it is in the window and the mean of its samples
  /// differs by more than `threshold` from a neighbour's, in any channel of the first layer. Not
  /// while others commit.
  [[nodiscard]] std::vector<std::uint8_t> differingPixels(const PixelWindow& window,
                                                          float threshold) const;

 private:
  [[nodiscard]] std::size_t index(std::uint32_t x, std::uint32_t y) const noexcept {
    return static_cast<std::size_t>(y) * size_.width + x;
  }
  [[nodiscard]] bool differs(std::uint32_t x, std::uint32_t y, float threshold) const noexcept;

  ImageSize size_;
  std::vector<std::vector<PixelSum>> layers_;
  mutable std::mutex mutex_;
};

}  // namespace planetree::render
