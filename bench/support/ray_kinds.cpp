#include "bench/support/ray_kinds.hpp"

#include "bench/support/random.hpp"

#include <planetree/build_tree.hpp>

#include <cmath>
#include <optional>

namespace planetree::bench {

namespace {

/// Of the diagonal of the scene's bounds.
constexpr double kOcclusionReach = 0.15;
constexpr double kSurfaceOffset = 2e-5;
/// Of the size of the bounds, to each side.
constexpr double kRandomMargin = 0.05;
/// Of the diagonal. In a flat scene every origin would lie in the surface or a rounding error off
/// it, where engines may differ: Embree's fast modes take tMin for outside of the interval, its
/// robust modes for inside, and both flush the denormals by which a box may be larger than the
/// face.
constexpr double kLeastRandomSize = 0.01;

/// Each kind has numbers of its own, so that asking for fewer kinds changes none of the others.
std::uint64_t seedOf(RayKind kind) {
  return 20'260'101u + static_cast<std::uint64_t>(kind);
}

/// Where a secondary ray starts: off the surface, on the side of the viewer.
struct SurfacePoint {
  Vec3d position;
  Vec3d normal;  ///< unit length, toward the viewer
};

std::vector<Rayf> primaryRays(const render::Camera& camera, std::size_t size) {
  const render::PinholeCamera pinhole(camera, 1.0);
  const auto pixels = static_cast<double>(size);
  std::vector<Rayf> rays;
  rays.reserve(size * size);
  for (std::size_t y = 0; y < size; ++y) {
    for (std::size_t x = 0; x < size; ++x) {
      rays.push_back(pinhole.ray((static_cast<double>(x) + 0.5) / pixels,
                                 (static_cast<double>(y) + 0.5) / pixels));
    }
  }
  return rays;
}

SurfacePoint surfacePoint(const Rayf& ray, const Hitf& hit, double diagonal) {
  const Vec3d direction(ray.direction);
  const Vec3d normal(hit.normal);
  const Vec3d towardViewer = dot(normal, direction) > 0.0 ? -normal : normal;
  const Vec3d point = Vec3d(ray.origin) + direction * static_cast<double>(hit.t);
  return {point + towardViewer * (kSurfaceOffset * diagonal), towardViewer};
}

template <class O>
std::vector<SurfacePoint> visiblePoints(const KdTree<O>& tree, const std::vector<Rayf>& primary,
                                        double diagonal) {
  std::vector<SurfacePoint> points;
  points.reserve(primary.size());
  for (const Rayf& ray : primary) {
    if (const auto hit = tree.findIntersection(ray))
      points.push_back(surfacePoint(ray, *hit, diagonal));
  }
  return points;
}

std::vector<Rayf> cosineRays(const std::vector<SurfacePoint>& points, std::uint64_t seed,
                             float tMax) {
  Random random(seed);
  std::vector<Rayf> rays;
  rays.reserve(points.size());
  for (const SurfacePoint& point : points) {
    const render::CameraAxes frame = render::cameraAxes(point.normal, Vec3d{0.0, 1.0, 0.0});
    const Vec3d local = random.cosineDirection();
    const Vec3d direction = frame.right * local.x + frame.up * local.y + point.normal * local.z;
    rays.push_back({Vec3f(point.position), Vec3f(normalized(direction)), 0.0f, tMax});
  }
  return rays;
}

/// A corner and the size of a box.
struct Place {
  Vec3d lower;
  Vec3d size;
};

/// The bounds, thickened where they are too flat.
Place placeOfOrigins(const Box3& bounds) {
  Place place = {.lower = Vec3d(bounds.lower), .size = Vec3d(bounds.upper) - Vec3d(bounds.lower)};
  const double least = kLeastRandomSize * length(place.size);
  for (const Axis axis : kAxes) {
    if (place.size[axis] < least) {
      place.lower[axis] -= (least - place.size[axis]) / 2.0;
      place.size[axis] = least;
    }
  }
  return place;
}

std::vector<Rayf> randomRays(const Box3& bounds, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const auto [lower, size] = placeOfOrigins(bounds);
  const auto inside = [&] { return random.between(-kRandomMargin, 1.0 + kRandomMargin); };
  std::vector<Rayf> rays;
  rays.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    // One statement for each number: the order of a call's arguments is the compiler's choice.
    const double x = lower.x + size.x * inside();
    const double y = lower.y + size.y * inside();
    const double z = lower.z + size.z * inside();
    rays.push_back({.origin = Vec3f(Vec3d{x, y, z}), .direction = Vec3f(random.direction())});
  }
  return rays;
}

}  // namespace

std::string_view rayKindName(RayKind kind) noexcept {
  switch (kind) {
    case RayKind::Primary:
      return "primary";
    case RayKind::AmbientOcclusion:
      return "ao";
    case RayKind::Diffuse:
      return "diffuse";
    case RayKind::Random:
      return "random";
  }
  return "unknown";
}

namespace {

template <class O>
std::vector<RaySet> makeRaySets(const KdTree<O>& tree, const render::Camera& camera,
                                const std::vector<RayKind>& kinds, const RayCounts& counts) {
  const bool isEmpty = tree.bounds().isEmpty();
  const double diagonal =
      isEmpty ? 0.0 : length(Vec3d(tree.bounds().upper) - Vec3d(tree.bounds().lower));
  const std::vector<Rayf> primary = primaryRays(camera, counts.pictureSize);
  const std::vector<SurfacePoint> points = visiblePoints(tree, primary, diagonal);

  std::vector<RaySet> sets;
  for (const RayKind kind : kinds) {
    const std::uint64_t seed = seedOf(kind);
    switch (kind) {
      case RayKind::Primary:
        sets.push_back({kind, primary, counts.pictureSize});
        break;
      case RayKind::AmbientOcclusion:
        sets.push_back(
            {kind, cosineRays(points, seed, static_cast<float>(kOcclusionReach * diagonal))});
        break;
      case RayKind::Diffuse:
        sets.push_back({kind, cosineRays(points, seed, Rayf{}.tMax)});
        break;
      case RayKind::Random:
        sets.push_back({kind, isEmpty ? std::vector<Rayf>{}
                                      : randomRays(tree.bounds(), counts.randomCount, seed)});
        break;
    }
  }
  return sets;
}

}  // namespace

std::vector<RaySet> makeRaySets(const SceneObjects& objects, const render::Camera& camera,
                                const std::vector<RayKind>& kinds, const RayCounts& counts) {
  return objects.visit(
      [&](auto input) { return makeRaySets(buildTree(input), camera, kinds, counts); });
}

}  // namespace planetree::bench
