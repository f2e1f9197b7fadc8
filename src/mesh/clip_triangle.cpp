#include <planetree/mesh/clip_triangle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace planetree {
namespace {

// A triangle gains at most one corner at each of the six planes; rounding may dent the polygon and
// add a few more.
constexpr std::size_t kMaxCornerCount = 16;

struct Polygon {
  std::array<Vec3d, kMaxCornerCount> corners;
  std::size_t size = 0;
  bool hasOverflowed = false;

  void add(const Vec3d& corner) noexcept {
    if (size == kMaxCornerCount) {
      hasOverflowed = true;
    } else {
      corners[size++] = corner;
    }
  }
};

/// The part of the half space on one side of an axis-parallel plane; `sign` is +1 to keep what is
/// above the position and -1 to keep what is below.
struct HalfSpace {
  Axis axis;
  double position;
  double sign;

  [[nodiscard]] double depth(const Vec3d& point) const noexcept {
    return (point[axis] - position) * sign;
  }
};

/// Makes `inside` what of a polygon is in the half space.
void clip(const Polygon& polygon, const HalfSpace& side, Polygon& inside) noexcept {
  inside.size = 0;
  inside.hasOverflowed = polygon.hasOverflowed;
  if (polygon.size == 0)
    return;
  const double firstDepth = side.depth(polygon.corners[0]);
  double fromDepth = firstDepth;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const bool isLast = i + 1 == polygon.size;
    const Vec3d& from = polygon.corners[i];
    const Vec3d& to = polygon.corners[isLast ? 0 : i + 1];
    const double toDepth = isLast ? firstDepth : side.depth(to);
    if (fromDepth >= 0.0)
      inside.add(from);
    const bool crosses = (fromDepth > 0.0 && toDepth < 0.0) || (fromDepth < 0.0 && toDepth > 0.0);
    if (crosses)
      inside.add(from + (to - from) * (fromDepth / (fromDepth - toDepth)));
    fromDepth = toDepth;
  }
}

double largestCoordinate(const Polygon& polygon, const Box3& cell) noexcept {
  double largest = 0.0;
  for (const Axis axis : kAxes) {
    for (std::size_t i = 0; i < polygon.size; ++i) {
      largest = std::max(largest, std::fabs(polygon.corners[i][axis]));
    }
    largest = std::max(largest, std::fabs(static_cast<double>(cell.lower[axis])));
    largest = std::max(largest, std::fabs(static_cast<double>(cell.upper[axis])));
  }
  return largest;
}

}  // namespace

template <class T>
Box3 clippedTriangleBounds(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c,
                           const Box3& cell) noexcept {
  Box3 triangleBounds;
  triangleBounds.extend(a);
  triangleBounds.extend(b);
  triangleBounds.extend(c);
  const Box3 bounds = intersection(triangleBounds, cell);
  if (bounds.isEmpty() || contains(cell, triangleBounds))
    return bounds;

  Polygon first;
  Polygon second;
  first.add(static_cast<Vec3d>(a));
  first.add(static_cast<Vec3d>(b));
  first.add(static_cast<Vec3d>(c));

  // The corners that clipping makes are off by some ulps of a double for each plane. Clipping
  // against a cell that is larger by a margin far above that keeps every true point, and growing
  // the result by the margin covers the error of the points that are kept; docs/numerics.md has the
  // derivation. The margin is still far below an ulp of a float, so that it costs one ulp at most.
  const double margin = largestCoordinate(first, cell) * 0x1p-44;
  Polygon* polygon = &first;
  Polygon* inside = &second;
  const auto keep = [&](const HalfSpace& side) {
    clip(*polygon, side, *inside);
    std::swap(polygon, inside);
  };
  for (const Axis axis : kAxes) {
    const double lower = static_cast<double>(cell.lower[axis]) - margin;
    const double upper = static_cast<double>(cell.upper[axis]) + margin;
    if (static_cast<double>(triangleBounds.lower[axis]) < lower) {
      keep({axis, lower, 1.0});
    }
    if (static_cast<double>(triangleBounds.upper[axis]) > upper) {
      keep({axis, upper, -1.0});
    }
  }
  if (polygon->hasOverflowed)
    return bounds;
  if (polygon->size == 0)
    return {};

  Box3 clipped;
  for (const Axis axis : kAxes) {
    double lower = polygon->corners[0][axis];
    double upper = lower;
    for (std::size_t i = 1; i < polygon->size; ++i) {
      lower = std::min(lower, polygon->corners[i][axis]);
      upper = std::max(upper, polygon->corners[i][axis]);
    }
    clipped.lower[axis] = roundDown(lower - margin);
    clipped.upper[axis] = roundUp(upper + margin);
  }
  // Where the triangle's own box or the cell is tighter it is exact: a flat triangle stays flat.
  return intersection(clipped, bounds);
}

template Box3 clippedTriangleBounds(const Vec3f&, const Vec3f&, const Vec3f&, const Box3&) noexcept;
template Box3 clippedTriangleBounds(const Vec3d&, const Vec3d&, const Vec3d&, const Box3&) noexcept;

}  // namespace planetree
