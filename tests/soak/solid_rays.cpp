#include "soak/solid_rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace planetree::test {
namespace {

constexpr std::size_t kStyles = 5;

/// A face that rays are aimed at, in double.
struct Target {
  std::size_t face;
  Vec3d a;
  Vec3d b;
  Vec3d c;
};

/// The target with this number: every face comes three times, each time from another corner, so
/// that its corners and edges all have their turn.
template <class T>
Target targetOf(const PlacedSolid<T>& solid, std::uint64_t number) noexcept {
  const std::uint64_t turn = number % (3 * solid.mesh.faces.size());
  const auto face = static_cast<std::size_t>(turn / 3);
  const auto first = static_cast<std::size_t>(turn % 3);
  const auto corner = [&](std::size_t i) {
    return static_cast<Vec3d>(solid.mesh.positions[solid.mesh.faces[face][(first + i) % 3]]);
  };
  return {face, corner(0), corner(1), corner(2)};
}

/// A vertex, a point of an edge, or a point of the face.
Vec3d pointOf(const Target& target, std::size_t kind, FastRandom& random) noexcept {
  switch (kind % 5) {
    case 0:
      return target.a;
    case 1:
      return (target.a + target.b) * 0.5;
    case 2:
      return target.a + (target.b - target.a) * random.unit();
    case 3:
      return (target.a + target.b + target.c) / 3.0;
    default: {
      const Vec3d onEdge = target.a + (target.b - target.a) * random.unit();
      return onEdge + (target.c - onEdge) * random.unit();
    }
  }
}

/// The difference as a caller has it: of numbers of type T.
template <class T>
Vec3<T> directionTo(const Vec3<T>& origin, const Vec3d& target) noexcept {
  return static_cast<Vec3<T>>(target) - origin;
}

template <class T>
Vec3<T> axisDirection(Axis axis, FastRandom& random) noexcept {
  Vec3<T> direction{T(0), random.chance(0.5) ? T(0) : T(-0.0), T(0)};
  direction[axis] = random.chance(0.5) ? T(1) : T(-1);
  return direction;
}

/// One ray through the middle, the others around it in steps of a power of two.
template <class T>
void fillWithPicture(const Vec3<T>& origin, const Vec3d& middle, FastRandom& random,
                     std::span<Ray<T>> rays) noexcept {
  const Vec3<T> forward = directionTo(origin, middle);
  const auto ahead = static_cast<Vec3d>(forward);
  const double size = std::max({std::fabs(ahead.x), std::fabs(ahead.y), std::fabs(ahead.z)});
  const double step = size * std::exp2(-4.0 - static_cast<double>(random.below(24)));
  const Vec3d right = cross(ahead, random.inCube());
  const Vec3d up = cross(ahead, right);
  const auto scaled = [&](const Vec3d& v) { return normalized(v) * step; };
  const auto width = static_cast<std::size_t>(std::sqrt(static_cast<double>(rays.size())));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto x = static_cast<double>(i % width) - static_cast<double>(width / 2);
    const auto y = static_cast<double>(i / width) - static_cast<double>(width / 2);
    rays[i] = {origin, static_cast<Vec3<T>>(ahead + scaled(right) * x + scaled(up) * y)};
  }
}

/// From inside along an axis, at the heights of a vertex as far as these are inside.
template <class T>
Ray<T> axisRay(const PlacedSolid<T>& solid, const Target& target, FastRandom& random) noexcept {
  const Vec3d core = solid.cores[solid.coreOfFace[target.face]];
  const Axis axis = kAxes[random.below(3)];
  auto origin = static_cast<Vec3d>(innerPoint(solid, target.face, random));
  for (const Axis across : {nextAxis(axis), nextAxis(nextAxis(axis))}) {
    // Three such distances together stay within the half of the ball that is allowed.
    if (std::fabs(target.a[across] - core[across]) < 0.25 * solid.clearance)
      origin[across] = target.a[across];
  }
  return {static_cast<Vec3<T>>(origin), axisDirection<T>(axis, random)};
}

/// From close to the surface along an edge, in the plane of a face, or nearly so.
template <class T>
Ray<T> grazingRay(const PlacedSolid<T>& solid, const Target& target, FastRandom& random) noexcept {
  const Vec3<T> origin = innerPointAtSurface(solid, target.face, random);
  Vec3d along = target.b - target.a;
  const std::size_t kind = random.below(4);
  if (kind == 1)
    along = along * random.unit() + (target.c - target.a) * random.unit();
  if (kind == 2)
    along = target.a - static_cast<Vec3d>(origin);
  if (kind == 3) {
    const double size = length(along);
    const double tilt = size * std::exp2(-static_cast<double>(random.below(40)));
    along = along + random.inCube() * tilt;
  }
  // Of corners that rounding has made one there is no direction.
  auto direction = static_cast<Vec3<T>>(along);
  if (direction == Vec3<T>{})
    direction = axisDirection<T>(Axis::X, random);
  return {origin, direction};
}

FastRandom randomOf(std::uint64_t seed, std::uint64_t block) noexcept {
  return FastRandom(FastRandom(seed).next() + block);
}

}  // namespace

template <class T>
Vec3<T> innerPoint(const PlacedSolid<T>& solid, std::size_t face, FastRandom& random) noexcept {
  const Vec3d core = solid.cores[solid.coreOfFace[face]];
  // In a cube that a ball of half the radius holds.
  const double half = 0.28 * solid.clearance;
  Vec3d point = core + random.inCube() * half;
  if (random.chance(0.5)) {
    const double grid = std::exp2(std::floor(std::log2(half)) - 4.0);
    for (const Axis axis : kAxes) {
      const double snapped = std::round(point[axis] / grid) * grid;
      if (std::fabs(snapped - core[axis]) < half)
        point[axis] = snapped;
    }
  }
  return static_cast<Vec3<T>>(point);
}

template <class T>
Vec3<T> innerPointAtSurface(const PlacedSolid<T>& solid, std::size_t face,
                            FastRandom& random) noexcept {
  const Vec3d core = solid.cores[solid.coreOfFace[face]];
  const Target target = targetOf(solid, 3 * face);
  const Vec3d point = pointOf(target, 4, random);
  const double step = solid.stepInside + random.unit() * random.unit() * (0.5 - solid.stepInside);
  return static_cast<Vec3<T>>(point + (core - point) * step);
}

template <class T>
void fillWithInnerRays(const PlacedSolid<T>& solid, std::uint64_t seed, std::uint64_t block,
                       std::span<Ray<T>> rays) {
  FastRandom random = randomOf(seed, block);
  const std::size_t style = block % kStyles;
  const std::uint64_t firstTarget = block / kStyles * rays.size();
  const Target first = targetOf(solid, firstTarget);
  const Vec3<T> shared = innerPoint(solid, first.face, random);
  if (style == 2) {
    // One picture takes one target: the number of the picture says which.
    const Target target = targetOf(solid, block / kStyles);
    fillWithPicture(innerPoint(solid, target.face, random),
                    pointOf(target, random.below(3), random), random, rays);
    return;
  }
  const std::size_t sharedKind = block / kStyles % 5;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Target target = targetOf(solid, firstTarget + i);
    switch (style) {
      case 0: {
        const Vec3<T> origin = innerPoint(solid, target.face, random);
        rays[i] = {origin, directionTo(origin, pointOf(target, random.below(5), random))};
        break;
      }
      case 1:
        rays[i] = {shared, directionTo(shared, pointOf(target, sharedKind, random))};
        break;
      case 3:
        rays[i] = axisRay(solid, target, random);
        break;
      default:
        rays[i] = grazingRay(solid, target, random);
    }
  }
}

template <class T>
void fillWithOuterRays(const PlacedSolid<T>& solid, std::uint64_t seed, std::uint64_t block,
                       std::span<Ray<T>> rays) {
  FastRandom random = randomOf(~seed, block);
  const auto outerPoint = [&] {
    // Out of the ball around the middle that holds the box of the solid.
    const Vec3d away = normalized(random.inCube() + Vec3d{1e-3, 0.0, 0.0});
    return static_cast<Vec3<T>>(solid.center + away * (solid.extent * (1.0 + 3.0 * random.unit())));
  };
  const std::uint64_t firstTarget = block * rays.size();
  Vec3<T> origin = outerPoint();
  if (block % 3 == 2) {
    fillWithPicture(origin, pointOf(targetOf(solid, block / 3), random.below(3), random), random,
                    rays);
    return;
  }
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Target target = targetOf(solid, firstTarget + i);
    if (block % 3 == 0)
      origin = outerPoint();
    Vec3<T> direction = directionTo(origin, pointOf(target, random.below(5), random));
    if (random.chance(0.1))
      direction = axisDirection<T>(kAxes[random.below(3)], random);
    rays[i] = {origin, direction};
  }
}

#define PLANETREE_INSTANTIATE(T)                                                                  \
  template Vec3<T> innerPoint(const PlacedSolid<T>&, std::size_t, FastRandom&) noexcept;          \
  template Vec3<T> innerPointAtSurface(const PlacedSolid<T>&, std::size_t, FastRandom&) noexcept; \
  template void fillWithInnerRays(const PlacedSolid<T>&, std::uint64_t, std::uint64_t,            \
                                  std::span<Ray<T>>);                                             \
  template void fillWithOuterRays(const PlacedSolid<T>&, std::uint64_t, std::uint64_t,            \
                                  std::span<Ray<T>>);
PLANETREE_INSTANTIATE(float)
PLANETREE_INSTANTIATE(double)
#undef PLANETREE_INSTANTIATE

}  // namespace planetree::test
