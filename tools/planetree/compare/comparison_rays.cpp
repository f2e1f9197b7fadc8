#include "compare/comparison_rays.hpp"

#include "render/sample_points.hpp"
#include "render/shading/surface_point.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

namespace planetree::tool {

namespace {

/// As far as ambient occlusion looks in pictures.
constexpr float kReachOfDiagonal = 0.15f;

/// Numbers in [0, 1) that are the same on every machine.
class Numbers {
 public:
  double next() { return static_cast<double>(engine_() >> 11u) * 0x1p-53; }
  Vec3d nextDirection() {
    const double z = 2.0 * next() - 1.0;
    const double turn = 2.0 * std::numbers::pi * next();
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * std::cos(turn), radius * std::sin(turn), z};
  }

 private:
  std::mt19937_64 engine_{20'270'101u};
};

std::vector<Rayf> primaryRays(const render::PinholeCamera& camera, std::uint32_t size) {
  std::vector<Rayf> rays;
  rays.reserve(std::size_t{size} * size);
  for (std::uint32_t y = 0; y < size; ++y) {
    for (std::uint32_t x = 0; x < size; ++x)
      rays.push_back(camera.ray((x + 0.5) / size, (y + 0.5) / size));
  }
  return rays;
}

std::vector<Rayf> aoRays(const render::Tracer& tracer, const std::vector<Rayf>& primary,
                         Numbers& numbers) {
  std::vector<Hitf> hits(primary.size());
  tracer.findIntersections(primary, hits, 0);
  const Box3 bounds = tracer.bounds();
  const float reach = kReachOfDiagonal * render::diagonal(bounds);
  std::vector<Rayf> rays;
  for (std::size_t i = 0; i < primary.size(); ++i) {
    if (!render::isSurface(hits[i]))
      continue;
    const Vec3f normal = render::normalTowardViewer(hits[i], primary[i]);
    const Vec3f point = primary[i].at(hits[i].t);
    const double u = numbers.next();
    const render::Point2 sample{u, numbers.next()};
    rays.push_back({.origin = point + normal * render::surfaceOffset(bounds, point),
                    .direction = render::cosineDistributed(normal, sample),
                    .tMax = reach});
  }
  return rays;
}

std::vector<Rayf> randomRays(const Box3& bounds, std::size_t count, Numbers& numbers) {
  const Vec3d lower(bounds.lower);
  const Vec3d size = Vec3d(bounds.upper) - lower;
  std::vector<Rayf> rays;
  rays.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    // One statement for each number: the order of a call's arguments is the compiler's choice.
    const double x = lower.x + size.x * numbers.next();
    const double y = lower.y + size.y * numbers.next();
    const double z = lower.z + size.z * numbers.next();
    rays.push_back({.origin = Vec3f(Vec3d{x, y, z}), .direction = Vec3f(numbers.nextDirection())});
  }
  return rays;
}

}  // namespace

ComparisonRays makeComparisonRays(const render::Tracer& tracer, const render::PinholeCamera& camera,
                                  std::uint32_t pictureSize) {
  Numbers numbers;
  ComparisonRays rays{.primary = primaryRays(camera, pictureSize), .ao = {}, .random = {}};
  rays.ao = aoRays(tracer, rays.primary, numbers);
  rays.random = randomRays(tracer.bounds(), rays.primary.size(), numbers);
  return rays;
}

}  // namespace planetree::tool
