#include "render/progressive_film.hpp"

#include <algorithm>
#include <cmath>

namespace planetree::render {

namespace {

template <class Visit>
void forEachRow(const Tile& tile, const ImageSize& size, const Visit& visit) {
  const std::uint32_t width = tile.endX - tile.firstX;
  for (std::uint32_t y = tile.firstY; y < tile.endY; ++y) {
    visit(static_cast<std::ptrdiff_t>(y) * size.width + tile.firstX,
          static_cast<std::ptrdiff_t>(y - tile.firstY) * width, width);
  }
}

bool isFarther(const Vec3f& a, const Vec3f& b, float threshold) noexcept {
  return std::fabs(a.x - b.x) > threshold || std::fabs(a.y - b.y) > threshold ||
         std::fabs(a.z - b.z) > threshold;
}

}  // namespace

ProgressiveFilm::ProgressiveFilm(ImageSize size, std::size_t layerCount)
    : size_(size), layers_(layerCount, std::vector<PixelSum>(size.pixelCount())) {}

TileSums ProgressiveFilm::copyTile(const Tile& tile) const {
  TileSums sums{.tile = tile, .layers = {}};
  for (const std::vector<PixelSum>& layer : layers_) {
    std::vector<PixelSum>& copy = sums.layers.emplace_back();
    forEachRow(tile, size_, [&](std::ptrdiff_t from, std::ptrdiff_t /*to*/, std::uint32_t width) {
      copy.insert(copy.end(), layer.begin() + from, layer.begin() + from + width);
    });
  }
  return sums;
}

void ProgressiveFilm::commit(const TileSums& sums) {
  const std::scoped_lock lock(mutex_);
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    forEachRow(sums.tile, size_, [&](std::ptrdiff_t to, std::ptrdiff_t from, std::uint32_t width) {
      std::copy_n(sums.layers[i].begin() + from, width, layers_[i].begin() + to);
    });
  }
}

Film ProgressiveFilm::film(std::size_t layer, const PixelWindow& window) const {
  Film film(window.size);
  const std::scoped_lock lock(mutex_);
  for (std::uint32_t y = 0; y < window.size.height; ++y) {
    for (std::uint32_t x = 0; x < window.size.width; ++x)
      film.at(x, y) = layers_[layer][index(window.x + x, window.y + y)].mean();
  }
  return film;
}

std::vector<std::uint8_t> ProgressiveFilm::differingPixels(const PixelWindow& window,
                                                           float threshold) const {
  std::vector<std::uint8_t> flags(size_.pixelCount());
  for (std::uint32_t y = window.y; y < window.y + window.size.height; ++y) {
    for (std::uint32_t x = window.x; x < window.x + window.size.width; ++x)
      flags[index(x, y)] = differs(x, y, threshold) ? 1 : 0;
  }
  return flags;
}

bool ProgressiveFilm::differs(std::uint32_t x, std::uint32_t y, float threshold) const noexcept {
  const Vec3f own = layers_.front()[index(x, y)].mean().value;
  for (std::uint32_t j = y - std::min(y, 1u); j < std::min(y + 2, size_.height); ++j) {
    for (std::uint32_t i = x - std::min(x, 1u); i < std::min(x + 2, size_.width); ++i) {
      if (isFarther(own, layers_.front()[index(i, j)].mean().value, threshold))
        return true;
    }
  }
  return false;
}

}  // namespace planetree::render
