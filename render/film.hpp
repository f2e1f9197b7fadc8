#pragma once

#include "render/image.hpp"

#include <planetree/geometry/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace planetree::render {

/// What a camera ray brought back, or the mean over the rays of a pixel. What `value` means is up
/// to the shading; it is zero where nothing was seen, so means are weighted by `coverage`.
struct FilmSample {
  Vec3f value;
  float coverage = 0.0f;  ///< the part of the rays that saw something

  FilmSample& operator+=(const FilmSample& other) noexcept {
    value = value + other.value;
    coverage += other.coverage;
    return *this;
  }
};

/// The samples that a pixel has so far. They are added in their order, whatever time passes between
/// two of them: floats do not add up to the same in another one.
struct PixelSum {
  FilmSample sum;
  std::uint32_t count = 0;

  void add(const FilmSample& sample) noexcept {
    sum += sample;
    ++count;
  }
  /// Nothing without samples.
  [[nodiscard]] FilmSample mean() const noexcept {
    if (count == 0)
      return {};
    const float weight = 1.0f / static_cast<float>(count);
    return {.value = sum.value * weight, .coverage = sum.coverage * weight};
  }
};

/// The samples of a picture before they become colours, row by row from the top left.
class Film {
 public:
  explicit Film(ImageSize size) : size_(size), samples_(size.pixelCount()) {}

  [[nodiscard]] ImageSize size() const noexcept { return size_; }
  [[nodiscard]] const std::vector<FilmSample>& samples() const noexcept { return samples_; }

  [[nodiscard]] FilmSample& at(std::uint32_t x, std::uint32_t y) noexcept {
    return samples_[index(x, y)];
  }
  [[nodiscard]] const FilmSample& at(std::uint32_t x, std::uint32_t y) const noexcept {
    return samples_[index(x, y)];
  }

 private:
  [[nodiscard]] std::size_t index(std::uint32_t x, std::uint32_t y) const noexcept {
    return static_cast<std::size_t>(y) * size_.width + x;
  }

  ImageSize size_;
  std::vector<FilmSample> samples_;
};

}  // namespace planetree::render
