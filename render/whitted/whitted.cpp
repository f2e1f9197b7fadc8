#include "render/whitted/whitted.hpp"

#include "render/shading/surface_point.hpp"
#include "render/whitted/refraction.hpp"

#include <planetree/hit/next_ray.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace planetree::render {

namespace {

using scene::BuiltScene;
using scene::MaterialSample;
using scene::SurfacePoint;

Vec3d product(const Vec3d& a, const Vec3d& b) noexcept {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

bool isZero(const Vec3d& v) noexcept {
  return v == Vec3d{0, 0, 0};
}

/// A ray on its way, and the part of its light that reaches the eye.
struct Path {
  Rayf ray;
  Vec3d factor;
  std::uint32_t sample;  ///< whose light it is
};

/// What a lamp adds to a sample, unless something stands between.
struct LampPath {
  Rayf ray;
  Vec3d light;
  std::uint32_t sample;
};

/// The rays of one depth that are followed together: enough for a batch, and few enough that all
/// depths together need little memory.
constexpr std::size_t kPathsAtOnce = 4096;

/// The light of a set of rays.
class Illumination {
 public:
  Illumination(const BuiltScene& scene, const WhittedSettings& settings, RayCounter& tracer,
               std::size_t sampleCount)
      : scene_(scene), settings_(settings), tracer_(tracer), light_(sampleCount, Vec3d{0, 0, 0}) {}

  /// Follows the paths, and what they become at surfaces, at most `depth` times.
  void follow(std::span<const Path> paths, std::uint32_t depth) {
    forEachChunk(paths, [&](std::span<const Path> chunk, std::size_t /*first*/) {
      std::vector<Rayf> rays;
      rays.reserve(chunk.size());
      for (const Path& path : chunk)
        rays.push_back(path.ray);
      followFrom(chunk, tracer_.findIntersections(rays), depth);
    });
  }
  /// The same for paths whose first hits are known.
  void follow(std::span<const Path> paths, std::span<const Hitf> hits, std::uint32_t depth) {
    forEachChunk(paths, [&](std::span<const Path> chunk, std::size_t first) {
      followFrom(chunk, hits.subspan(first, chunk.size()), depth);
    });
  }

  [[nodiscard]] std::vector<Vec3d> takeLight() noexcept { return std::move(light_); }

 private:
  template <class Visit>
  static void forEachChunk(std::span<const Path> paths, const Visit& visit) {
    for (std::size_t first = 0; first < paths.size(); first += kPathsAtOnce)
      visit(paths.subspan(first, std::min(kPathsAtOnce, paths.size() - first)), first);
  }

  void followFrom(std::span<const Path> paths, std::span<const Hitf> hits, std::uint32_t depth) {
    const std::vector<Path> next = shade(paths, hits, depth > 0);
    if (!next.empty())
      follow(next, depth - 1);
  }

  /// Adds the light of the surfaces that the paths meet. Returns where they go on.
  std::vector<Path> shade(std::span<const Path> paths, std::span<const Hitf> hits, bool goesOn) {
    std::vector<Path> next;
    std::vector<LampPath> lamps;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const Path& path = paths[i];
      if (!isSurface(hits[i])) {
        light_[path.sample] = light_[path.sample] +
                              product(path.factor, scene_.background(Vec3d(path.ray.direction)));
        continue;
      }
      const SurfacePoint surface = scene_.surface(path.ray, hits[i], settings_.isSmooth);
      addOwnLight(path, surface);
      addLamps(path, hits[i], surface, lamps);
      if (goesOn)
        addNext(path, hits[i], surface, next);
    }
    illuminate(lamps);
    return next;
  }

  void addOwnLight(const Path& path, const SurfacePoint& surface) {
    const MaterialSample& material = surface.material;
    const Vec3d own =
        material.emissive + product(material.ambient, scene_.description().ambientLight);
    light_[path.sample] = light_[path.sample] + product(path.factor, own);
  }

  void addLamps(const Path& path, const Hitf& hit, const SurfacePoint& surface,
                std::vector<LampPath>& lamps) const {
    for (const scene::DirectionalLight& lamp : scene_.description().directionalLights) {
      const Vec3d toLamp = -normalized(lamp.direction);
      const Vec3d light = lamp.colour;
      if (const auto shown = reflectedLight(path, surface, toLamp, light))
        lamps.push_back({nextRayFrom(path, hit, toLamp), *shown, path.sample});
    }
    for (const scene::PointLight& lamp : scene_.description().pointLights) {
      const Vec3d between = lamp.position - surface.position;
      const double distance = length(between);
      if (!(distance > 0.0))
        continue;
      const double fading =
          lamp.constant + lamp.linear * distance + lamp.quadratic * distance * distance;
      const Vec3d light = lamp.colour * std::min(1.0, 1.0 / fading);
      if (const auto shown = reflectedLight(path, surface, between / distance, light)) {
        Rayf ray = nextRayFrom(path, hit, between / distance);
        // Its length is the way to the lamp: what stands behind that casts no shadow.
        ray.direction = Vec3f(lamp.position - Vec3d(ray.origin));
        ray.tMax = 1.0f;
        lamps.push_back({ray, *shown, path.sample});
      }
    }
  }

  /// What the eye gets of a lamp's light by way of the surface; nothing if that is none.
  [[nodiscard]] std::optional<Vec3d> reflectedLight(const Path& path, const SurfacePoint& surface,
                                                    const Vec3d& toLamp,
                                                    const Vec3d& light) const noexcept {
    const MaterialSample& material = surface.material;
    const double facing = std::max(dot(surface.normal, toLamp), 0.0);
    const Vec3d mirrored = reflected(-toLamp, surface.normal);
    const double glance = std::max(-dot(mirrored, Vec3d(path.ray.direction)), 0.0);
    const Vec3d shown = product(
        path.factor, product(light, material.diffuse * facing +
                                        material.specular * std::pow(glance, material.shininess)));
    if (isZero(shown))
      return std::nullopt;
    return shown;
  }

  void addNext(const Path& path, const Hitf& hit, const SurfacePoint& surface,
               std::vector<Path>& next) const {
    const Vec3d incoming(path.ray.direction);
    const Vec3d mirrored = product(path.factor, surface.material.reflective);
    if (!isZero(mirrored)) {
      next.push_back({nextRayFrom(path, hit, normalized(reflected(incoming, surface.normal))),
                      mirrored, path.sample});
    }
    const Vec3d passing = product(path.factor, surface.material.transmissive);
    if (isZero(passing))
      return;
    if (const auto behind = refracted(incoming, surface.normal, surface.material.index))
      next.push_back({nextRayFrom(path, hit, *behind), passing, path.sample});
  }

  [[nodiscard]] Rayf nextRayFrom(const Path& path, const Hitf& hit, const Vec3d& direction) const {
    return nextRay(path.ray, hit, Vec3f(direction), scene_.tree().bounds());
  }

  /// Adds the light of the lamps that reaches its sample.
  void illuminate(const std::vector<LampPath>& lamps) {
    std::vector<std::uint8_t> areShaded(lamps.size());
    if (settings_.hasShadows) {
      std::vector<Rayf> rays;
      rays.reserve(lamps.size());
      for (const LampPath& lamp : lamps)
        rays.push_back(lamp.ray);
      areShaded = tracer_.areOccluded(rays);
    }
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      const LampPath& lamp = lamps[i];
      if (areShaded[i] == 0) {
        light_[lamp.sample] = light_[lamp.sample] + lamp.light;
      } else if (scene_.hasTransparency()) {
        light_[lamp.sample] = light_[lamp.sample] + product(lamp.light, transmission(lamp.ray));
      }
    }
  }

  /// The part of the light that passes all surfaces on the ray, in their order, so that the first
  /// opaque one ends it.
  [[nodiscard]] Vec3d transmission(const Rayf& ray) {
    Vec3d passed{1, 1, 1};
    std::array<Hitf, 8> hits;
    FoundHits found = tracer_.findIntersections(ray, hits);
    for (;;) {
      for (std::size_t i = 0; i < found.count; ++i) {
        passed = product(passed, scene_.transmission(ray, hits[i]));
        if (isZero(passed))
          return passed;
      }
      if (!found.hasMore)
        return passed;
      found = tracer_.findNextIntersections(ray, hits[found.count - 1], hits);
    }
  }

  const BuiltScene& scene_;
  const WhittedSettings& settings_;
  RayCounter& tracer_;
  std::vector<Vec3d> light_;  ///< of each sample
};

}  // namespace

Whitted::Whitted(const BuiltScene& scene, const WhittedSettings& settings)
    : scene_(scene), settings_(settings) {}

std::vector<Vec3d> Whitted::radiance(RayCounter& tracer, std::span<const Rayf> rays) const {
  return radiance(tracer, rays, tracer.findIntersections(rays));
}

std::vector<Vec3d> Whitted::radiance(RayCounter& tracer, std::span<const Rayf> rays,
                                     std::span<const Hitf> hits) const {
  Illumination illumination(scene_, settings_, tracer, rays.size());
  std::vector<Path> paths;
  paths.reserve(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    paths.push_back({rays[i], {1, 1, 1}, static_cast<std::uint32_t>(i)});
  illumination.follow(paths, hits, settings_.depthLimit);
  return illumination.takeLight();
}

std::vector<FilmSample> Whitted::shade(RayCounter& tracer, CameraRays& camera) const {
  std::vector<FilmSample> samples;
  samples.reserve(camera.rays.size());
  for (const Vec3d& light : radiance(tracer, camera.rays, camera.hits(tracer))) {
    const auto clamped = [](double channel) {
      return static_cast<float>(std::clamp(channel, 0.0, 1.0));
    };
    samples.push_back(
        {.value = {clamped(light.x), clamped(light.y), clamped(light.z)}, .coverage = 1.0f});
  }
  return samples;
}

Development Whitted::develop(const Film& /*film*/) const {
  Development development;
  development.light = [](const FilmSample& sample) {
    return Light{.colour = sample.value, .alpha = sample.coverage};
  };
  development.isEncoded = true;
  return development;
}

}  // namespace planetree::render
