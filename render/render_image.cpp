#include "render/render_image.hpp"

#include "render/overlay/draw_cells.hpp"
#include "render/parallel_tiles.hpp"
#include "render/sample_points.hpp"
#include "render/shading/ambient_occlusion.hpp"
#include "render/shading/backdrop.hpp"
#include "render/shading/depth.hpp"
#include "render/shading/heat.hpp"
#include "render/shading/normals.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace planetree::render {

namespace {

std::unique_ptr<Shading> makeShading(const Tracer& tracer, const RenderSettings& settings,
                                     const CameraAxes& axes) {
  switch (settings.mode) {
    case RenderMode::Normals:
      return std::make_unique<Normals>();
    case RenderMode::Depth:
      return std::make_unique<Depth>(Vec3f(axes.forward));
    case RenderMode::Heat:
      return std::make_unique<Heat>(settings.heatMax);
    case RenderMode::AmbientOcclusion:
      break;
  }
  return std::make_unique<AmbientOcclusion>(tracer.bounds(), axes, settings.camera.up,
                                            settings.albedos);
}

/// A colour that stands out from all that the mode can show.
Vec3f wireColour(RenderMode mode) noexcept {
  constexpr Vec3f kInk{0.010f, 0.035f, 0.15f};
  constexpr Vec3f kIce{0.12f, 0.55f, 0.75f};
  constexpr Vec3f kAmber{1.00f, 0.45f, 0.02f};
  switch (mode) {
    case RenderMode::Heat:
      return kIce;
    case RenderMode::Depth:
      return kAmber;
    case RenderMode::AmbientOcclusion:
    case RenderMode::Normals:
      break;
  }
  return kInk;
}

/// Camera rays that a tile traces together: enough for neighbours to be taken along with each
/// other, few enough that they, and what they send on, stay in the cache.
constexpr std::size_t kRaysAtOnce = 2048;

/// One rendering: everything that all tiles share.
class TileRenderer {
 public:
  TileRenderer(const Tracer& tracer, const RenderSettings& settings, const PinholeCamera& camera,
               Progress& progress)
      : tracer_(tracer),
        settings_(settings),
        camera_(camera),
        progress_(progress),
        film_(settings.size),
        points_(settings.samplesPerPixel, settings.seed),
        shading_(makeShading(tracer, settings, camera_.axes())) {}

  /// Any number of tiles at once. Does nothing after a stop.
  void render(const Tile& tile) {
    RayCounter counter(tracer_);
    const std::size_t pixelCount =
        static_cast<std::size_t>(tile.endX - tile.firstX) * (tile.endY - tile.firstY);
    const std::size_t samplesPerPixel = settings_.samplesPerPixel;
    const std::size_t sampleCount = pixelCount * samplesPerPixel;
    for (std::size_t first = 0; first < sampleCount; first += kRaysAtOnce) {
      if (progress_.isStopped())
        return;
      const std::size_t end = std::min(sampleCount, first + kRaysAtOnce);
      renderSamples(counter, tile, first, end);
      progress_.add(end / samplesPerPixel - first / samplesPerPixel);
    }
    rayCount_ += counter.rayCount();
  }

  [[nodiscard]] std::uint64_t rayCount() const noexcept { return rayCount_; }
  [[nodiscard]] const Shading& shading() const noexcept { return *shading_; }
  [[nodiscard]] Film& film() noexcept { return film_; }

 private:
  /// The samples of a tile are numbered pixel by pixel, and the pixels row by row.
  void renderSamples(RayCounter& counter, const Tile& tile, std::size_t first, std::size_t end) {
    const std::uint32_t samplesPerPixel = settings_.samplesPerPixel;
    const std::uint32_t width = tile.endX - tile.firstX;
    CameraRays camera;
    std::vector<FilmSample*> pixels;
    for (std::size_t i = first; i < end; ++i) {
      const auto pixel = static_cast<std::uint32_t>(i / samplesPerPixel);
      const std::uint32_t x = tile.firstX + pixel % width;
      const std::uint32_t y = tile.firstY + pixel / width;
      const SamplePoint point = points_.at(x, y, static_cast<std::uint32_t>(i % samplesPerPixel));
      camera.rays.push_back(camera_.ray((x + point.film.x) / settings_.size.width,
                                        (y + point.film.y) / settings_.size.height));
      camera.directions.push_back(point.directions);
      pixels.push_back(&film_.at(x, y));
    }
    const std::vector<FilmSample> samples = shading_->shade(counter, camera);
    const float weight = 1.0f / static_cast<float>(samplesPerPixel);
    for (std::size_t i = first; i < end; ++i) {
      FilmSample& sum = *pixels[i - first];
      sum += samples[i - first];
      const bool isLast = (i + 1) % samplesPerPixel == 0;
      if (isLast)
        sum = {.value = sum.value * weight, .coverage = sum.coverage * weight};
    }
  }

  const Tracer& tracer_;
  const RenderSettings& settings_;
  const PinholeCamera& camera_;
  Progress& progress_;
  Film film_;
  SamplePoints points_;
  std::unique_ptr<Shading> shading_;
  std::atomic<std::uint64_t> rayCount_ = 0;
};

/// Adds the four channels of a layer; the main one has no name.
template <class LightAt>
void addColours(ChannelImage& image, const std::string& layer, const LightAt& lightAt) {
  const std::size_t first = image.channels.size();
  for (const char* colour : {"R", "G", "B", "A"}) {
    Channel& channel = image.channels.emplace_back(
        Channel{.name = layer + colour, .type = ChannelType::Half, .values = {}});
    channel.values.reserve(image.size.pixelCount());
  }
  for (std::uint32_t y = 0; y < image.size.height; ++y) {
    for (std::uint32_t x = 0; x < image.size.width; ++x) {
      const Light light = lightAt(x, y);
      const std::array values = {light.colour.x, light.colour.y, light.colour.z, light.alpha};
      for (std::size_t i = 0; i < values.size(); ++i)
        image.channels[first + i].values.push_back(values[i]);
    }
  }
}

}  // namespace

std::optional<Rendering> renderImage(const Tracer& tracer, const RenderSettings& settings) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const PinholeCamera camera(settings.camera,
                             static_cast<double>(settings.size.width) / settings.size.height);
  const std::size_t pixelCount = settings.size.pixelCount();
  Progress progress(settings.keepsGoing, settings.cellDepth ? 2 * pixelCount : pixelCount);

  TileRenderer renderer(tracer, settings, camera, progress);
  forEachTile(settings.size, settings.threadCount,
              [&](const Tile& tile) { renderer.render(tile); });
  std::uint64_t rayCount = renderer.rayCount();
  std::optional<WireLayer> cells;
  if (settings.cellDepth && !progress.isStopped()) {
    cells = drawCells(tracer, camera,
                      {.size = settings.size,
                       .depth = *settings.cellDepth,
                       .colour = wireColour(settings.mode),
                       .threadCount = settings.threadCount},
                      progress);
    rayCount += kRaysPerCellPixel * pixelCount;
  }
  if (progress.isStopped())
    return std::nullopt;

  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const Development development = renderer.shading().develop(renderer.film());
  return Rendering{.film = std::move(renderer.film()),
                   .development = development,
                   .range = development.range,
                   .cells = std::move(cells),
                   .rayCount = rayCount,
                   .seconds = seconds};
}

Image shownImage(const Rendering& rendering) {
  const ImageSize size = rendering.film.size();
  Image image(size);
  for (std::uint32_t y = 0; y < size.height; ++y) {
    for (std::uint32_t x = 0; x < size.width; ++x) {
      Light light = rendering.development.light(rendering.film.at(x, y));
      if (rendering.development.hasBackdrop)
        light = over(light, {backdrop(size, x, y), 1.0f});
      if (rendering.cells)
        light = over(rendering.cells->light(x, y), light);
      image.at(x, y) =
          quantized(rendering.development.isEncoded ? light.colour : srgbEncoded(light.colour));
    }
  }
  return image;
}

ChannelImage channelImage(const Rendering& rendering) {
  const Film& film = rendering.film;
  ChannelImage image{.size = film.size(), .channels = {}};
  addColours(image, "", [&](std::uint32_t x, std::uint32_t y) {
    return rendering.development.light(film.at(x, y));
  });
  for (const Measurement& measurement : rendering.development.measurements) {
    Channel& channel = image.channels.emplace_back(
        Channel{.name = measurement.channel, .type = ChannelType::Float, .values = {}});
    channel.values.reserve(film.samples().size());
    for (const FilmSample& sample : film.samples())
      channel.values.push_back(measurement.value(sample));
  }
  if (rendering.cells) {
    addColours(image, "cells.",
               [&](std::uint32_t x, std::uint32_t y) { return rendering.cells->light(x, y); });
  }
  return image;
}

}  // namespace planetree::render
