#pragma once

#include <planetree/batch/ray_arrays.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace planetree::detail {

/// One number of all rays, or of all hits: that of number i stands at `first[i * stride]`.
template <class T>
struct Column {
  T* first = nullptr;
  std::size_t stride = 1;

  [[nodiscard]] T& operator[](std::size_t i) const noexcept { return first[i * stride]; }
};

template <class T>
[[nodiscard]] constexpr Column<T> columnOf(std::span<T> array) noexcept {
  return {array.data(), 1};
}

/// Rays wherever they stand.
template <class T>
struct RayColumns {
  static constexpr T kNoTMin = T(0);
  static constexpr T kNoTMax = std::numeric_limits<T>::infinity();

  std::array<Column<const T>, 3> origin;
  std::array<Column<const T>, 3> direction;
  Column<const T> tMin = {&kNoTMin, 0};
  Column<const T> tMax = {&kNoTMax, 0};
  std::size_t count = 0;
  const Ray<T>* records = nullptr;  ///< the rays, if their numbers stand side by side

  explicit RayColumns(std::span<const Ray<T>> rays) noexcept
      : count(rays.size()), records(rays.data()) {
    constexpr std::size_t kStride = sizeof(Ray<T>) / sizeof(T);
    if (rays.empty())
      return;
    const T* const first = &rays.front().origin.x;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      origin[axis] = {first + axis, kStride};
      direction[axis] = {first + 3 + axis, kStride};
    }
    tMin = {first + 6, kStride};
    tMax = {first + 7, kStride};
  }
  explicit RayColumns(const RayArrays<T>& rays) noexcept
      : origin{columnOf(rays.originX), columnOf(rays.originY), columnOf(rays.originZ)},
        direction{columnOf(rays.directionX), columnOf(rays.directionY), columnOf(rays.directionZ)},
        count(rays.originX.size()) {
    if (!rays.tMin.empty())
      tMin = columnOf(rays.tMin);
    if (!rays.tMax.empty())
      tMax = columnOf(rays.tMax);
  }

  /// Fetches a ray that is wanted soon, where its numbers stand side by side.
  void fetch(std::size_t i) const noexcept {
    if (records != nullptr)
      __builtin_prefetch(records + i);
  }

  [[nodiscard]] Ray<T> operator[](std::size_t i) const noexcept {
    if (records != nullptr)
      return records[i];
    return {.origin = {origin[0][i], origin[1][i], origin[2][i]},
            .direction = {direction[0][i], direction[1][i], direction[2][i]},
            .tMin = tMin[i],
            .tMax = tMax[i]};
  }
};

/// Hits wherever they are to stand.
template <class T>
class HitColumns {
 public:
  explicit HitColumns(std::span<Hit<T>> hits) noexcept : hits_(hits) {}
  explicit HitColumns(const HitArrays<T>& arrays) noexcept : arrays_(arrays) {}

  /// Fetches where a hit will be written soon.
  void fetch(std::size_t i) const noexcept {
    if (!hits_.empty())
      __builtin_prefetch(&hits_[i], 1);
  }

  void write(std::size_t i, const Hit<T>& hit) const noexcept {
    if (!hits_.empty()) {
      hits_[i] = hit;
      return;
    }
    put(arrays_.t, i, hit.t);
    put(arrays_.u, i, hit.u);
    put(arrays_.v, i, hit.v);
    put(arrays_.normalX, i, hit.normal.x);
    put(arrays_.normalY, i, hit.normal.y);
    put(arrays_.normalZ, i, hit.normal.z);
    put(arrays_.geometry, i, hit.geometry);
    put(arrays_.primitive, i, hit.primitive);
    put(arrays_.part, i, hit.part);
  }

 private:
  template <class N>
  static void put(std::span<N> array, std::size_t i, N number) noexcept {
    if (!array.empty())
      array[i] = number;
  }

  std::span<Hit<T>> hits_ = {};
  HitArrays<T> arrays_ = {};
};

}  // namespace planetree::detail
