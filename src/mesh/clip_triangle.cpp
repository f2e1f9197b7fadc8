#include <planetree/mesh/clip_triangle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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

Polygon clip(const Polygon& polygon, const HalfSpace& side) noexcept {
  Polygon inside;
  inside.hasOverflowed = polygon.hasOverflowed;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vec3d& from = polygon.corners[i];
    const Vec3d& to = polygon.corners[i + 1 < polygon.size ? i + 1 : 0];
    const double fromDepth = side.depth(from);
    const double toDepth = side.depth(to);
    if (fromDepth >= 0.0)
      inside.add(from);
    const bool crosses = (fromDepth > 0.0 && toDepth < 0.0) || (fromDepth < 0.0 && toDepth > 0.0);
    if (crosses)
      inside.add(from + (to - from) * (fromDepth / (fromDepth - toDepth)));
  }
  return inside;
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

  Polygon polygon;
  polygon.add(static_cast<Vec3d>(a));
  polygon.add(static_cast<Vec3d>(b));
  polygon.add(static_cast<Vec3d>(c));

  // The corners that clipping makes are off by some ulps of a double for each plane. Clipping
  // against a cell that is larger by a margin far above that keeps every true point, and growing
  // the result by the margin covers the error of the points that are kept; docs/numerics.md has the
  // derivation. The margin is still far below an ulp of a float, so that it costs one ulp at most.
  const double margin = largestCoordinate(polygon, cell) * 0x1p-44;
  for (const Axis axis : kAxes) {
    const double lower = static_cast<double>(cell.lower[axis]) - margin;
    const double upper = static_cast<double>(cell.upper[axis]) + margin;
    if (static_cast<double>(triangleBounds.lower[axis]) < lower) {
      polygon = clip(polygon, {axis, lower, 1.0});
    }
    if (static_cast<double>(triangleBounds.upper[axis]) > upper) {
      polygon = clip(polygon, {axis, upper, -1.0});
    }
  }
  if (polygon.hasOverflowed)
    return bounds;

  Box3 clipped;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vec3d& corner = polygon.corners[i];
    clipped.extend(corner - Vec3d{margin, margin, margin});
    clipped.extend(corner + Vec3d{margin, margin, margin});
  }
  // Where the triangle's own box or the cell is tighter it is exact: a flat triangle stays flat.
  return intersection(clipped, bounds);
}

template Box3 clippedTriangleBounds(const Vec3f&, const Vec3f&, const Vec3f&, const Box3&) noexcept;
template Box3 clippedTriangleBounds(const Vec3d&, const Vec3d&, const Vec3d&, const Box3&) noexcept;

}  // namespace planetree
