#pragma once

#include "render/point2.hpp"

#include <planetree/geometry/vec3.hpp>

#include <array>
#include <cstdint>

namespace planetree::render {

/// How many directions a shading may try for each camera ray.
inline constexpr std::uint32_t kDirectionsPerSample = 4;

/// Points to choose directions by, of coordinates in [0, 1).
using DirectionPoints = std::array<Point2, kDirectionsPerSample>;

/// What one sample of a pixel is made of.
struct SamplePoint {
  Point2 film;  ///< the place within the pixel, in [0, 1) each way
  DirectionPoints directions;
};

/// The low-discrepancy points of a picture. Every sample is a function of seed, pixel and number
/// alone, so a picture is the same whatever thread draws which part of it.
///
/// The points are Sobol's first two dimensions with the hash-based Owen scrambling of Burley,
/// "Practical hash-based Owen scrambling", JCGT 2020, once for the film and once, differently
/// shuffled, for the direction. Unlike there, pixels do not take a sequence each: along a Morton
/// curve, neighbours take consecutive parts of one sequence, which makes their errors differ and so
/// less visible (Ahmed and Wonka, "Screen-space blue-noise diffusion of Monte Carlo sampling error
/// via hierarchical ordering of pixels", ACM TOG 2020).
class SamplePoints {
 public:
  SamplePoints(std::uint32_t samplesPerPixel, std::uint64_t seed) noexcept
      : samplesPerPixel_(samplesPerPixel), seed_(seed) {}

  /// Best spread if the number of samples is a power of two.
  [[nodiscard]] SamplePoint at(std::uint32_t pixelX, std::uint32_t pixelY,
                               std::uint32_t sample) const noexcept;

 private:
  std::uint32_t samplesPerPixel_;
  std::uint64_t seed_;
};

/// A unit direction around the unit vector `normal`, whose density is proportional to the cosine of
/// the angle between the two.
[[nodiscard]] Vec3f cosineDistributed(const Vec3f& normal, const Point2& point) noexcept;

}  // namespace planetree::render
