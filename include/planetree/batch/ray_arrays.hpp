#pragma once

#include <cstdint>
#include <span>

namespace planetree {

/// Rays as an array for each of their numbers. All have one length, but for the last two: without
/// `tMin` it is 0 for all rays, without `tMax` infinite. Nothing is copied.
template <class T>
struct RayArrays {
  std::span<const T> originX;
  std::span<const T> originY;
  std::span<const T> originZ;
  std::span<const T> directionX;
  std::span<const T> directionY;
  std::span<const T> directionZ;
  std::span<const T> tMin = {};
  std::span<const T> tMax = {};
};

/// Hits as an array for each of their numbers, of the length of the rays, or empty if nobody wants
/// it; `Hit::instance`, which is always 0, has none. A ray without a hit has t infinite, `kNoId`
/// for the ids, and 0 in all others.
template <class T>
struct HitArrays {
  std::span<T> t = {};
  std::span<T> u = {};
  std::span<T> v = {};
  std::span<T> normalX = {};
  std::span<T> normalY = {};
  std::span<T> normalZ = {};
  std::span<std::uint32_t> geometry = {};
  std::span<std::uint32_t> primitive = {};
  std::span<std::uint32_t> part = {};
};

using RayArraysf = RayArrays<float>;
using RayArraysd = RayArrays<double>;
using HitArraysf = HitArrays<float>;
using HitArraysd = HitArrays<double>;

}  // namespace planetree
