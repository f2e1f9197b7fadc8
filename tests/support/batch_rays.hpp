#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include "support/hard_cases.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

/// Batches of rays as callers have them, and as an implementation that takes neighbours along
/// together would rather not have them.
namespace planetree::test {

template <class T>
struct RaySet {
  std::string name;
  std::vector<Ray<T>> rays;
};

/// What a camera looks at: the middle of the picture, and half of its sides.
template <class T>
struct PictureFrame {
  Vec3<T> forward;
  Vec3<T> right;
  Vec3<T> up;
};

/// A picture row by row from its top left, its rays through the middles of the pixels. With odd
/// sizes some go straight ahead, along axes if the frame does.
template <class T>
std::vector<Ray<T>> pinholePicture(const Vec3<T>& eye, const PictureFrame<T>& frame, int width,
                                   int height) {
  std::vector<Ray<T>> rays;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const T u = static_cast<T>(2 * x + 1 - width) / static_cast<T>(width);
      const T v = static_cast<T>(height - 2 * y - 1) / static_cast<T>(height);
      rays.push_back({eye, frame.forward + frame.right * u + frame.up * v});
    }
  }
  return rays;
}

/// The same with parallel rays. The first row and column begin on the sides of the frame, so that
/// origins of a frame along a box lie in its sides and in the planes that halve it.
template <class T>
std::vector<Ray<T>> parallelPicture(const Vec3<T>& eye, const PictureFrame<T>& frame, int width,
                                    int height) {
  std::vector<Ray<T>> rays;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const T u = static_cast<T>(2 * x) / static_cast<T>(width - 1) - T(1);
      const T v = static_cast<T>(2 * y) / static_cast<T>(height - 1) - T(1);
      rays.push_back({eye + frame.right * u + frame.up * v, frame.forward});
    }
  }
  return rays;
}

/// All around, row by row: neighbours are alike, but the picture has all octants and main axes.
template <class T>
std::vector<Ray<T>> panorama(const Vec3<T>& eye, int width, int height) {
  std::vector<Ray<T>> rays;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double around = 2.0 * std::numbers::pi * x / width;
      const double down = std::numbers::pi * (y + 0.5) / height;
      rays.push_back(
          {eye, static_cast<Vec3<T>>(Vec3d{std::sin(down) * std::cos(around),
                                           std::sin(down) * std::sin(around), std::cos(down)})});
    }
  }
  return rays;
}

/// Three sides of a cube of directions whose components are whole numbers: zeros of both signs, and
/// components of exactly one size, where the main axis changes.
template <class T>
std::vector<Ray<T>> wholeDirections(const Vec3<T>& eye, int n, std::uint64_t salt) {
  Random random(salt);
  std::vector<Ray<T>> rays;
  for (const Axis axis : kAxes) {
    for (int i = -n; i <= n; ++i) {
      for (int j = -n; j <= n; ++j) {
        Vec3<T> direction;
        direction[axis] = static_cast<T>(random.chance(0.1) ? -n : n);
        direction[nextAxis(axis)] = static_cast<T>(i);
        direction[nextAxis(nextAxis(axis))] = static_cast<T>(j);
        for (const Axis any : kAxes) {
          if (direction[any] == T(0) && random.chance(0.5))
            direction[any] = T(-0.0);
        }
        rays.push_back({eye, direction});
      }
    }
  }
  return rays;
}

/// Directions with components of almost one size: neighbours lie in different octants of the
/// permuted axes, a rounding apart.
template <class T>
std::vector<Ray<T>> nearlyDiagonal(const Vec3<T>& eye, int count, std::uint64_t salt) {
  Random random(salt);
  std::vector<Ray<T>> rays;
  while (static_cast<int>(rays.size()) < count) {
    Vec3<T> direction{T(1), T(1), T(-1)};
    for (const Axis axis : kAxes) {
      const std::size_t kind = random.below(3);
      if (kind == 1)
        direction[axis] = std::nextafter(direction[axis], T(0));
      if (kind == 2)
        direction[axis] *= static_cast<T>(1.0 + random.between(-1e-4, 1e-4));
    }
    rays.push_back({eye, direction});
  }
  return rays;
}

/// From one point at the corners and the middles of the edges, face by face: neighbours are alike,
/// and pass through what several faces share.
template <class T>
std::vector<Ray<T>> raysAtSharedPlaces(const TriangleMesh<T>& mesh, const Vec3<T>& eye,
                                       std::size_t mostFaces) {
  std::vector<Ray<T>> rays;
  for (std::size_t i = 0; i < std::min(mesh.faces.size(), mostFaces); ++i) {
    const auto& [a, b, c] = mesh.faces[i];
    if (std::max({a, b, c}) >= mesh.positions.size())
      continue;
    const std::array corners = {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3<T> next = corners[(k + 1) % 3];
      rays.push_back({eye, corners[k] - eye});
      rays.push_back({eye, (corners[k] + next) / T(2) - eye});
    }
  }
  return rays;
}

template <class T>
std::vector<Ray<T>> randomRays(const Box3& box, int count, std::uint64_t salt) {
  Random random(salt);
  const Vec3d lower(box.lower);
  const Vec3d size = Vec3d(box.upper) - lower;
  std::vector<Ray<T>> rays;
  while (static_cast<int>(rays.size()) < count)
    rays.push_back({random.pointIn<T>(lower - size * 0.2, lower + size * 1.2),
                    static_cast<Vec3<T>>(random.direction())});
  return rays;
}

/// Sets of rays through a scene in this box. `mesh` is what some of them are aimed at.
template <class T>
std::vector<RaySet<T>> raySets(const TriangleMesh<T>& mesh, const Box3& bounds,
                               std::uint64_t salt) {
  const Box3 box = bounds.isEmpty() ? Box3{{-1, -1, -1}, {1, 1, 1}} : bounds;
  const auto lower = static_cast<Vec3<T>>(box.lower);
  const auto upper = static_cast<Vec3<T>>(box.upper);
  const Vec3<T> middle = (lower + upper) / T(2);
  const Vec3<T> half = (upper - lower) / T(2);
  const T reach = std::max({half.x, half.y, half.z, std::numeric_limits<T>::min()});
  const T r = reach * T(0.9);
  const Vec3<T> before{middle.x, middle.y, upper.z + T(2) * reach};
  const Vec3<T> corner = middle + Vec3<T>{reach, reach, reach} * T(1.9);
  const Vec3<T> inside = middle + half * T(0.31);
  const PictureFrame<T> ahead{{0, 0, T(-1.8)}, {T(0.9), 0, 0}, {0, T(0.9), 0}};
  const PictureFrame<T> diagonal{{-1, -1, -1}, {T(0.3), T(-0.3), 0}, {T(-0.2), T(-0.2), T(0.4)}};
  const PictureFrame<T> wide{{0, T(0.01), 1}, {2, 0, 0}, {0, 2, 0}};
  const PictureFrame<T> alongBox{{0, 0, -1}, {half.x, 0, 0}, {0, half.y, 0}};
  const PictureFrame<T> aslant{{-1, T(-0.7), T(-0.8)}, {r, -r, 0}, {0, -r, r}};

  std::vector<RaySet<T>> sets;
  sets.push_back({"picture of 64 x 48", pinholePicture(before, ahead, 64, 48)});
  sets.push_back({"picture of 100 x 37, diagonal", pinholePicture(corner, diagonal, 100, 37)});
  sets.push_back({"picture of 5 x 400, inside", pinholePicture(inside, wide, 5, 400)});
  sets.push_back({"wide picture of 61 x 33, middle", pinholePicture(middle, wide, 61, 33)});
  sets.push_back({"panorama", panorama(inside, 72, 36)});
  sets.push_back({"panorama from a corner", panorama(upper, 40, 20)});
  sets.push_back({"parallel, along the box", parallelPicture(before, alongBox, 65, 33)});
  sets.push_back({"parallel, aslant", parallelPicture(corner, aslant, 40, 40)});
  sets.push_back({"whole directions", wholeDirections(middle, 16, salt + 1)});
  sets.push_back({"nearly diagonal", nearlyDiagonal(middle, 300, salt + 2)});
  sets.push_back({"at shared places", raysAtSharedPlaces(mesh, before, 300)});
  sets.push_back({"at shared places, from the middle", raysAtSharedPlaces(mesh, middle, 300)});
  sets.push_back({"one ray many times", std::vector<Ray<T>>(100, Ray<T>{corner, middle - corner})});
  sets.push_back({"random", randomRays<T>(box, 1500, salt + 3)});
  sets.push_back({"hard", hardRays(mesh, bounds, 1500, salt + 4)});
  return sets;
}

/// The same rays in any order.
template <class T>
std::vector<Ray<T>> shuffled(std::vector<Ray<T>> rays, std::uint64_t salt) {
  Random random(salt);
  for (std::size_t i = rays.size(); i > 1; --i)
    std::swap(rays[i - 1], rays[random.below(i)]);
  return rays;
}

/// Runs of any length from one, then from the other: what was coherent ends anywhere.
template <class T>
std::vector<Ray<T>> mixed(const std::vector<Ray<T>>& some, const std::vector<Ray<T>>& others,
                          std::uint64_t salt) {
  Random random(salt);
  std::vector<Ray<T>> rays;
  for (std::size_t i = 0; i < some.size() && i < others.size();) {
    const bool takesOthers = random.chance(0.4);
    const std::size_t end = std::min({some.size(), others.size(), i + 1 + random.below(50)});
    for (; i < end; ++i)
      rays.push_back(takesOthers ? others[i] : some[i]);
  }
  return rays;
}

/// Rays whose numbers are too large or too small for tests of boxes in float. Some of them hit.
template <class T>
std::vector<Ray<T>> rangelessRays() {
  const T denormal = std::numeric_limits<T>::denorm_min() * T(100);
  const T huge = T(1e30);
  return {{{0, 0, 5}, {0, 0, -huge}},
          {{0, 0, 5}, {0, 0, T(-1e-30)}},
          {{0, 0, 5}, {denormal, -denormal, -denormal}},
          {{huge, huge, huge}, {-1, -1, -1}},
          {{0, 0, huge}, {0, 0, -1}},
          {{huge, 0, 0}, {-huge, T(1e-30), 0}},
          {{T(0.1), T(0.2), 5}, {T(1e-38), T(-1e-38), -1}},
          {{T(0.1), T(0.2), 5}, {0, 0, -std::numeric_limits<T>::max()}},
          {{T(0.1), T(0.2), 5}, {0, 0, -1}, -huge, huge},
          {{T(0.1), T(0.2), 5}, {0, 0, -1}, -std::numeric_limits<T>::max()}};
}

/// Some of the rays give way to such as miss by definition, or are out of range.
template <class T>
std::vector<Ray<T>> withBadRays(std::vector<Ray<T>> rays, std::uint64_t salt) {
  Random random(salt);
  std::vector<Ray<T>> bad = invalidRays<T>();
  const std::vector<Ray<T>> rangeless = rangelessRays<T>();
  bad.insert(bad.end(), rangeless.begin(), rangeless.end());
  for (Ray<T>& ray : rays) {
    if (random.chance(0.1))
      ray = bad[random.below(bad.size())];
  }
  return rays;
}

/// The same rays with intervals of every kind. `hitTs` says where each ray hits, if it does: some
/// intervals end or begin there, to the last bit.
template <class T>
std::vector<Ray<T>> withIntervals(std::vector<Ray<T>> rays, const std::vector<T>& hitTs,
                                  std::uint64_t salt) {
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  Random random(salt);
  std::size_t kind = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    // Neighbours often have one kind, but not always.
    if (random.chance(0.3))
      kind = random.below(12);
    const T hitT = std::isfinite(hitTs[i]) ? hitTs[i] : T(1);
    const auto anywhere = hitT * static_cast<T>(random.between(0.0, 2.0));
    Ray<T>& ray = rays[i];
    switch (kind) {
      case 0:
        ray.tMax = hitT;
        break;
      case 1:
        ray.tMax = std::nextafter(hitT, T(0));
        break;
      case 2:
        ray.tMin = hitT;
        break;
      case 3:
        ray.tMin = std::nextafter(hitT, kInfinity);
        break;
      case 4:
        ray.tMin = ray.tMax = hitT;
        break;
      case 5:
        ray.tMin = -anywhere;
        break;
      case 6:
        ray.tMin = -kInfinity;
        break;
      case 7:
        ray.tMax = anywhere;
        break;
      case 8:
        ray.tMax = hitT * T(1e-6);
        break;
      case 9:
        ray.tMin = anywhere;
        ray.tMax = anywhere / T(2);
        break;
      case 10:
        ray.tMin = -anywhere;
        ray.tMax = -anywhere / T(2);
        break;
      default:
        break;
    }
  }
  return rays;
}

}  // namespace planetree::test
