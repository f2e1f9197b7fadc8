#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/geometry/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// A judge of answers that rounds nothing: the exact kernel of CGAL, and none of the library's own
/// arithmetic. Rays and corners come in double, which holds every float as it is. Not for several
/// threads at once.
///
/// What a wrong answer is
/// ----------------------
/// The library decides a triangle from corners that are moved, sheared along the ray and rounded
/// (docs/numerics.md, section 1). Let D be the largest distance, along any axis, between the ray's
/// origin and a corner of the tree's bounds, and b the documented bound: 8 u D for float, 25 u D
/// for double. Positions are compared as the test does: `z` is the axis along which the direction
/// is largest, and a point is *near* the ray if the ray's point with the same z is at most b away
/// from it along both other axes. This is a distance in the sheared plane, where the ray is the
/// origin.
///
/// 1. A hit is false if no point of its triangle is within b, along every axis, of the point that
///    was reported: `origin + t * direction`, without rounding.
/// 2. Misses are false where the ray certainly passes. A sheared corner is rounded off its place by
///    at most 6 u D, less than b, along each axis. Move all corners from where they are to where
///    rounding puts them: then no point of a triangle's outline moves by more than b, so that an
///    outline that is not near the ray never sweeps over it, and winds around the ray as before. So
///    a triangle that the ray passes through at a distance of more than b from its outline is hit
///    by the rounded test, too. The same is true of several triangles together, a *patch*, whose
///    outline is what is left of their edges once those that two of them share, in opposite
///    directions, are struck out: if the outline is not near, and winds around the ray, then one
///    triangle of the patch at least is hit, and with `QueryOptions::crossings` the hits from
///    behind less those from the front are the number of times that it winds. For a ray through an
///    edge or a vertex of a mesh the triangles that share it make such a patch.
/// 3. The point that the test puts a hit at is within b of a point of the triangle that is itself
///    near the ray. So the t of a hit lies between those of the near points of its triangle, but
///    for b along z. This is the triangle's *window*; it is narrow, but for triangles seen nearly
///    edge-on. A miss is judged if the window lies inside the interval of the ray, and a nearest
///    hit is false if it lies behind the window of a patch that must be hit.
///
/// What remains is *open*: the outline of a patch is near, or the end of an interval lies in its
/// window. There either answer is right.
namespace planetree::test {

using Corners = std::array<Vec3d, 3>;

/// How a ray and a triangle meet, as points of space, without any bound.
enum class Meeting : std::uint8_t {
  Hit,       ///< through the inside of the triangle, t strictly inside the interval
  Miss,      ///< no point in common
  Touching,  ///< on an edge or a vertex, in the plane of the triangle, or at an end of the interval
};

struct ExactMeeting {
  Meeting kind = Meeting::Miss;
  /// Between which doubles the exact t of the points in common lies; NaN for a miss.
  double tLower = 0.0;
  double tUpper = 0.0;
  /// The distance in the sheared plane between the ray's line and the outline of the triangle: how
  /// far the ray is inside, or, negative, how far outside.
  double depth = 0.0;
};

/// The ray must have a finite origin and a finite direction that is not zero.
[[nodiscard]] ExactMeeting meet(const Rayd& ray, const Corners& corners);

/// Triangles that are near a ray, joined where they share an edge that is near.
struct Patch {
  std::vector<std::uint32_t> faces;
  double tLower = 0.0;  ///< the window
  double tUpper = 0.0;
  bool isCertain = false;  ///< the outline is not near the ray
  int winding = 0;  ///< how often a certain outline winds around the ray; positive from behind

  /// Whether a ray with this interval has to hit one of the triangles.
  [[nodiscard]] bool mustBeHit(double tMin, double tMax) const noexcept {
    return isCertain && winding != 0 && isWithin(tMin, tMax);
  }
  [[nodiscard]] bool isWithin(double tMin, double tMax) const noexcept {
    return tMin <= tLower && tUpper <= tMax;
  }
};

/// What is to be expected of a ray.
struct Expectation {
  std::vector<Patch> patches;
  std::uint64_t hitCount = 0;  ///< of triangles, by `Meeting`
  std::uint64_t missCount = 0;
  std::uint64_t touchingCount = 0;

  /// The patch of a face, or null if it is not near the ray.
  [[nodiscard]] const Patch* patchOf(std::uint32_t face) const noexcept;
};

/// The judge of one mesh.
class ExactJudge {
 public:
  /// `faces` by their number; those with a corner that is not finite are taken for skipped.
  /// `bounds` are those of the tree, `boundInRoundoffs` is 8 or 25 and `roundoff` is u.
  ExactJudge(std::span<const Corners> faces, const Box3& bounds, double boundInRoundoffs,
             double roundoff);

  [[nodiscard]] Expectation expect(const Rayd& ray) const;

  /// Whether the point at t is no farther from the triangle, along every axis, than so many
  /// roundoffs of D. False for a t that is not finite and for a face that is not there.
  [[nodiscard]] bool isWithin(const Rayd& ray, double t, std::uint32_t face, int roundoffs) const;

  /// That distance, rounded up to a whole number of roundoffs; `most` if it is no less.
  [[nodiscard]] int distanceInRoundoffs(const Rayd& ray, double t, std::uint32_t face,
                                        int most) const;

  [[nodiscard]] double boundInRoundoffs() const noexcept { return boundInRoundoffs_; }

 private:
  struct Face {
    std::uint32_t number;
    Corners corners;
    std::array<std::uint32_t, 3> places;  ///< numbers of the corners: equal ones have one number
  };

  /// D, the unit of the bound, exactly as long as a double holds the difference of two floats.
  [[nodiscard]] double largestDistance(const Rayd& ray) const noexcept;

  std::vector<Corners> corners_;
  std::vector<Face> faces_;
  Box3 bounds_;
  double boundInRoundoffs_;
  double roundoff_;
};

}  // namespace planetree::test
