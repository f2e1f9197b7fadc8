#include "render/render_image.hpp"

#include "render/film.hpp"
#include "render/sample_points.hpp"
#include "render/shading/ambient_occlusion.hpp"
#include "render/shading/depth.hpp"
#include "render/shading/heat.hpp"
#include "render/shading/normals.hpp"

#include <tbb/blocked_range2d.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>

namespace planetree::render {

namespace {

/// Side of the square tiles that threads take on. Small enough to share the work evenly, large
/// enough that the rays of a tile find the nodes they need in the cache.
constexpr std::size_t kTileSide = 16;

using Tile = tbb::blocked_range2d<std::uint32_t>;

std::unique_ptr<Shading> makeShading(const Tracer& tracer, const RenderSettings& settings,
                                     const CameraAxes& axes) {
  switch (settings.mode) {
    case RenderMode::Normals:
      return std::make_unique<Normals>();
    case RenderMode::Depth:
      return std::make_unique<Depth>(Vec3f(axes.forward));
    case RenderMode::Heat:
      return std::make_unique<Heat>();
    case RenderMode::AmbientOcclusion:
      break;
  }
  return std::make_unique<AmbientOcclusion>(tracer.bounds(), axes, settings.camera.up,
                                            settings.albedos);
}

/// One rendering: everything that all tiles share.
class TileRenderer {
 public:
  TileRenderer(const Tracer& tracer, const RenderSettings& settings, Film& film)
      : tracer_(tracer),
        settings_(settings),
        film_(film),
        camera_(settings.camera, static_cast<double>(settings.size.width) / settings.size.height),
        points_(settings.samplesPerPixel, settings.seed),
        shading_(makeShading(tracer, settings, camera_.axes())) {}

  /// Any number of tiles at once. Does nothing after a stop.
  void render(const Tile& tile) {
    RayCounter counter(tracer_);
    for (std::uint32_t y = tile.rows().begin(); y != tile.rows().end(); ++y) {
      if (isStopped())
        return;
      for (std::uint32_t x = tile.cols().begin(); x != tile.cols().end(); ++x) {
        film_.at(x, y) = renderPixel(counter, x, y);
      }
      report(tile.cols().size());
    }
    rayCount_ += counter.rayCount();
  }

  [[nodiscard]] bool isStopped() const noexcept { return isStopped_; }
  [[nodiscard]] std::uint64_t rayCount() const noexcept { return rayCount_; }
  [[nodiscard]] const Shading& shading() const noexcept { return *shading_; }

 private:
  [[nodiscard]] FilmSample renderPixel(RayCounter& counter, std::uint32_t x,
                                       std::uint32_t y) const noexcept {
    FilmSample sum;
    for (std::uint32_t i = 0; i < settings_.samplesPerPixel; ++i) {
      const SamplePoint point = points_.at(x, y, i);
      const Rayf ray = camera_.ray((x + point.film.x) / settings_.size.width,
                                   (y + point.film.y) / settings_.size.height);
      sum += shading_->shade(counter, ray, point.directions);
    }
    const float weight = 1.0f / static_cast<float>(settings_.samplesPerPixel);
    return {.value = sum.value * weight, .coverage = sum.coverage * weight};
  }

  void report(std::size_t pixelCount) {
    if (!settings_.keepsGoing)
      return;
    const std::size_t done = pixelsDone_ += pixelCount;
    const double part = static_cast<double>(done) / static_cast<double>(film_.samples().size());
    if (!settings_.keepsGoing(part))
      isStopped_ = true;
  }

  const Tracer& tracer_;
  const RenderSettings& settings_;
  Film& film_;
  PinholeCamera camera_;
  SamplePoints points_;
  std::unique_ptr<Shading> shading_;
  std::atomic<std::size_t> pixelsDone_ = 0;
  std::atomic<std::uint64_t> rayCount_ = 0;
  std::atomic<bool> isStopped_ = false;
};

void renderAllTiles(TileRenderer& renderer, const RenderSettings& settings) {
  const int threadCount = settings.threadCount == 0 ? tbb::info::default_concurrency()
                                                    : static_cast<int>(settings.threadCount);
  // Without it oneTBB never runs more threads than the machine has.
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threadCount));
  tbb::task_arena arena(threadCount);
  const Tile picture(0, settings.size.height, kTileSide, 0, settings.size.width, kTileSide);
  arena.execute([&] {
    tbb::parallel_for(
        picture, [&](const Tile& tile) { renderer.render(tile); }, tbb::simple_partitioner());
  });
}

}  // namespace

std::optional<Rendering> renderImage(const Tracer& tracer, const RenderSettings& settings) {
  using Clock = std::chrono::steady_clock;
  Film film(settings.size);
  TileRenderer renderer(tracer, settings, film);
  const Clock::time_point start = Clock::now();
  renderAllTiles(renderer, settings);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (renderer.isStopped())
    return std::nullopt;

  DevelopedImage developed = renderer.shading().develop(film);
  return Rendering{.image = std::move(developed.image),
                   .range = developed.range,
                   .rayCount = renderer.rayCount(),
                   .seconds = seconds};
}

}  // namespace planetree::render
