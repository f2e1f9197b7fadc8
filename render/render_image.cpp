#include "render/render_image.hpp"

#include "render/overlay/draw_cells.hpp"
#include "render/parallel_tiles.hpp"
#include "render/progressive_film.hpp"
#include "render/sample_points.hpp"
#include "render/shading/albedo.hpp"
#include "render/shading/ambient_occlusion.hpp"
#include "render/shading/depth.hpp"
#include "render/shading/heat.hpp"
#include "render/shading/normals.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace planetree::render {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The camera rays that a tile traces together: enough for neighbours to be taken along with each
/// other, few enough that they, and what they send on, stay in the cache.
constexpr std::size_t kRaysAtOnce = 2048;

/// Tiles of few samples are larger than usual, for the same reason, where there are many of them.
constexpr std::uint32_t kLargeTileSide = 32;
constexpr std::uint32_t kFewSamples = 4;
constexpr std::size_t kManyPixels = std::size_t{1} << 17;

/// What takes less than this is not worth dividing, so that there is something to see.
constexpr double kShortSeconds = 0.5;

/// The part of the pixels that need all their samples, before it is known.
constexpr double kUsualDifferingPart = 0.15;

/// The picture and, in front of it, all that its layers are taken of.
using Shadings = std::vector<std::unique_ptr<const Shading>>;

Shadings makeShadings(const Tracer& tracer, const RenderSettings& settings,
                      const CameraAxes& axes) {
  Shadings shadings;
  const scene::BuiltScene* const scene = settings.scene;
  const Vec3f viewDirection(axes.forward);
  switch (settings.mode) {
    case RenderMode::Whitted:
      shadings.push_back(std::make_unique<Whitted>(*scene, settings.whitted));
      break;
    case RenderMode::Albedo:
      shadings.push_back(std::make_unique<Albedo>(*scene));
      break;
    case RenderMode::Normals:
      shadings.push_back(settings.hasShadingNormals ? std::make_unique<Normals>(*scene)
                                                    : std::make_unique<Normals>());
      break;
    case RenderMode::Depth:
      shadings.push_back(std::make_unique<Depth>(viewDirection));
      break;
    case RenderMode::Heat:
      shadings.push_back(std::make_unique<Heat>(settings.heatMax));
      break;
    case RenderMode::AmbientOcclusion:
      shadings.push_back(scene != nullptr
                             ? std::make_unique<AmbientOcclusion>(*scene, axes, settings.camera.up)
                             : std::make_unique<AmbientOcclusion>(
                                   tracer.bounds(), axes, settings.camera.up, settings.albedos));
      break;
  }
  if (settings.hasLayers && settings.mode == RenderMode::Whitted) {
    shadings.push_back(std::make_unique<Albedo>(*scene));
    shadings.push_back(settings.whitted.isSmooth ? std::make_unique<Normals>(*scene)
                                                 : std::make_unique<Normals>());
    shadings.push_back(std::make_unique<Depth>(viewDirection));
  }
  return shadings;
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
    case RenderMode::Whitted:
      return kAmber;
    case RenderMode::AmbientOcclusion:
    case RenderMode::Normals:
    case RenderMode::Albedo:
      break;
  }
  return kInk;
}

PinholeCamera makeCamera(const RenderSettings& settings) {
  if (settings.view)
    return PinholeCamera(*settings.view);
  return {settings.camera, static_cast<double>(settings.size.width) / settings.size.height};
}

PixelWindow chosenWindow(const RenderSettings& settings) {
  return settings.crop.value_or(PixelWindow{.x = 0, .y = 0, .size = settings.size});
}

/// The window and all pixels around it, within the picture.
PixelWindow withNeighbours(const PixelWindow& window, const ImageSize& picture) {
  const std::uint32_t x = window.x - std::min(window.x, 1u);
  const std::uint32_t y = window.y - std::min(window.y, 1u);
  const std::uint32_t endX = std::min(window.x + window.size.width + 1, picture.width);
  const std::uint32_t endY = std::min(window.y + window.size.height + 1, picture.height);
  return {.x = x, .y = y, .size = {endX - x, endY - y}};
}

/// A range of the samples of some pixels.
struct Pass {
  std::uint32_t firstSample = 0;
  std::uint32_t endSample = 0;
  std::vector<std::uint8_t> areChosen = {};  ///< one flag for each pixel; empty is all of them
};

/// One rendering: everything that all tiles share.
class ImageRenderer {
 public:
  ImageRenderer(const Tracer& tracer, const RenderSettings& settings)
      : tracer_(tracer),
        settings_(settings),
        camera_(makeCamera(settings)),
        samplesPerPixel_(settings.grid ? settings.grid->samplesPerPixel()
                                       : settings.samplesPerPixel),
        isAdaptive_(settings.grid && settings.grid->threshold && samplesPerPixel_ > 1),
        window_(chosenWindow(settings)),
        sampledWindow_(isAdaptive_ ? withNeighbours(window_, settings.size) : window_),
        points_(samplesPerPixel_, settings.seed),
        shadings_(makeShadings(tracer, settings, camera_.axes())),
        film_(sampledWindow_.size, shadings_.size()),
        progress_(settings.keepsGoing, 0) {}

  Rendering render() {
    if (isAdaptive_)
      renderAdaptively();
    else
      renderAllSamples();
    std::optional<WireLayer> cells = drawCellsIfWanted();
    Rendering rendering = soFar();
    rendering.cells = std::move(cells);
    rendering.isComplete = !progress_.isStopped();
    if (rendering.isComplete)
      rendering.done = 1.0;
    return rendering;
  }

 private:
  void renderAllSamples() {
    setSampleCount(pixelCount() * samplesPerPixel_);
    std::uint32_t first = 0;
    while (first < samplesPerPixel_ && !progress_.isStopped()) {
      const std::uint32_t end = endOfPass(first);
      renderPass({.firstSample = first, .endSample = end});
      first = end;
    }
  }

  /// After one sample each pass has as many as there are, until the rest is done in a moment.
  [[nodiscard]] std::uint32_t endOfPass(std::uint32_t first) const {
    if (!settings_.isProgressive)
      return samplesPerPixel_;
    if (first == 0)
      return 1;
    const double secondsLeft =
        secondsSince(start_) * (static_cast<double>(samplesPerPixel_) / first - 1.0);
    if (secondsLeft < kShortSeconds)
      return samplesPerPixel_;
    return std::min(samplesPerPixel_, 2 * first);
  }

  void renderAdaptively() {
    const auto others = static_cast<double>(samplesPerPixel_ - 1);
    setSampleCount(static_cast<std::size_t>(static_cast<double>(pixelCount()) *
                                            (1.0 + others * kUsualDifferingPart)));
    renderPass({.firstSample = 0, .endSample = 1});
    if (progress_.isStopped())
      return;
    const PixelWindow inside{
        .x = window_.x - sampledWindow_.x, .y = window_.y - sampledWindow_.y, .size = window_.size};
    Pass pass{.firstSample = 1,
              .endSample = samplesPerPixel_,
              .areChosen = film_.differingPixels(inside, *settings_.grid->threshold)};
    const auto chosenCount =
        static_cast<std::size_t>(std::count(pass.areChosen.begin(), pass.areChosen.end(), 1));
    setSampleCount(pixelCount() + chosenCount * (samplesPerPixel_ - 1));
    renderPass(pass);
  }

  void setSampleCount(std::size_t count) {
    sampleCount_ = count;
    // A pixel with cells takes about as many rays as one sample of ambient occlusion.
    progress_.setTotal(count + (settings_.cellDepth ? settings_.size.pixelCount() : 0));
  }

  void renderPass(const Pass& pass) {
    const bool hasLargeTiles =
        pass.endSample - pass.firstSample <= kFewSamples && pixelCount() >= kManyPixels;
    forEachTile(
        sampledWindow_.size, settings_.threadCount,
        [&](const Tile& tile) {
          renderTile(tile, pass);
          offerPreview();
        },
        hasLargeTiles ? kLargeTileSide : kTileSide);
  }

  /// Any number of tiles at once. Does nothing after a stop.
  void renderTile(const Tile& tile, const Pass& pass) {
    if (progress_.isStopped())
      return;
    const Clock::time_point start = Clock::now();
    RayCounter counter(tracer_);
    TileSums sums = film_.copyTile(tile);
    const std::vector<std::uint32_t> pixels = chosenPixels(tile, pass);
    const std::size_t samplesOfPixel = pass.endSample - pass.firstSample;
    const std::size_t count = pixels.size() * samplesOfPixel;
    std::size_t first = 0;
    while (first < count && !progress_.isStopped()) {
      const std::size_t end = std::min(count, first + kRaysAtOnce);
      renderSamples(counter, sums, pixels, pass, first, end);
      progress_.add(end - first);
      first = end;
    }
    // What was stopped within is left out: its pixels have different numbers of samples.
    if (first == count)
      film_.commit(sums);
    const std::scoped_lock lock(totalsMutex_);
    rayCount_ += counter.rayCount();
    tracingSeconds_ += counter.tracingSeconds();
    threadSeconds_ += secondsSince(start);
    committedCount_ += first == count ? count : 0;
  }

  /// The numbers of pixels in a tile, row by row.
  [[nodiscard]] std::vector<std::uint32_t> chosenPixels(const Tile& tile, const Pass& pass) const {
    std::vector<std::uint32_t> pixels;
    std::uint32_t number = 0;
    for (std::uint32_t y = tile.firstY; y < tile.endY; ++y) {
      for (std::uint32_t x = tile.firstX; x < tile.endX; ++x, ++number) {
        const std::size_t inFilm = static_cast<std::size_t>(y) * sampledWindow_.size.width + x;
        if (pass.areChosen.empty() || pass.areChosen[inFilm] != 0)
          pixels.push_back(number);
      }
    }
    return pixels;
  }

  /// The samples of a tile are numbered pixel by pixel.
  void renderSamples(RayCounter& counter, TileSums& sums, const std::vector<std::uint32_t>& pixels,
                     const Pass& pass, std::size_t first, std::size_t end) const {
    const std::size_t samplesOfPixel = pass.endSample - pass.firstSample;
    const std::uint32_t width = sums.tile.endX - sums.tile.firstX;
    CameraRays camera;
    camera.rays.reserve(end - first);
    camera.directions.reserve(end - first);
    for (std::size_t i = first; i < end; ++i) {
      const std::uint32_t pixel = pixels[i / samplesOfPixel];
      const std::uint32_t x = sampledWindow_.x + sums.tile.firstX + pixel % width;
      const std::uint32_t y = sampledWindow_.y + sums.tile.firstY + pixel / width;
      const SamplePoint point =
          samplePoint(x, y, pass.firstSample + static_cast<std::uint32_t>(i % samplesOfPixel));
      camera.rays.push_back(camera_.ray((x + point.film.x) / settings_.size.width,
                                        (y + point.film.y) / settings_.size.height));
      camera.directions.push_back(point.directions);
    }
    for (std::size_t layer = 0; layer < shadings_.size(); ++layer) {
      const std::vector<FilmSample> samples = shadings_[layer]->shade(counter, camera);
      for (std::size_t i = first; i < end; ++i)
        sums.layers[layer][pixels[i / samplesOfPixel]].add(samples[i - first]);
    }
  }

  [[nodiscard]] SamplePoint samplePoint(std::uint32_t x, std::uint32_t y,
                                        std::uint32_t sample) const noexcept {
    if (!settings_.grid)
      return points_.at(x, y, sample);
    // Nothing else asks for directions.
    SamplePoint point = settings_.mode == RenderMode::AmbientOcclusion
                            ? points_.at(x, y, sample)
                            : SamplePoint{.film = {}, .directions = {}};
    point.film = gridPoint(*settings_.grid, sample);
    return point;
  }

  void offerPreview() {
    if (!settings_.onPreview || progress_.isStopped() ||
        secondsSince(start_) < nextPreview_.load() || isPreviewing_.test_and_set())
      return;
    settings_.onPreview(soFar());
    nextPreview_ = secondsSince(start_) + settings_.previewSeconds;
    isPreviewing_.clear();
  }

  [[nodiscard]] std::optional<WireLayer> drawCellsIfWanted() {
    if (!settings_.cellDepth || progress_.isStopped())
      return std::nullopt;
    std::optional<WireLayer> cells = drawCells(tracer_, camera_,
                                               {.size = settings_.size,
                                                .depth = *settings_.cellDepth,
                                                .colour = wireColour(settings_.mode),
                                                .threadCount = settings_.threadCount},
                                               progress_);
    rayCount_ += kRaysPerCellPixel * settings_.size.pixelCount();
    return cells;
  }

  /// What there is, while other threads go on.
  [[nodiscard]] Rendering soFar() {
    const PixelWindow inside{
        .x = window_.x - sampledWindow_.x, .y = window_.y - sampledWindow_.y, .size = window_.size};
    Rendering rendering{.film = film_.film(0, inside),
                        .window = window_,
                        .wholeSize = settings_.size,
                        .development = {},
                        .layers = {},
                        .range = {},
                        .cells = {}};
    rendering.seconds = secondsSince(start_);
    rendering.development = shadings_.front()->develop(rendering.film);
    rendering.range = rendering.development.range;
    for (std::size_t i = 1; i < shadings_.size(); ++i) {
      Film film = film_.film(i, inside);
      std::vector<Measurement> measurements = shadings_[i]->develop(film).measurements;
      rendering.layers.push_back({std::move(film), std::move(measurements)});
    }
    const std::scoped_lock lock(totalsMutex_);
    rendering.rayCount = rayCount_;
    rendering.tracingSeconds = tracingSeconds_;
    rendering.shadingSeconds = threadSeconds_ - tracingSeconds_;
    if (sampleCount_ != 0)
      rendering.done = static_cast<double>(committedCount_) / static_cast<double>(sampleCount_);
    return rendering;
  }

  [[nodiscard]] std::size_t pixelCount() const noexcept { return sampledWindow_.size.pixelCount(); }

  const Tracer& tracer_;
  const RenderSettings& settings_;
  const Clock::time_point start_ = Clock::now();
  PinholeCamera camera_;
  std::uint32_t samplesPerPixel_;
  bool isAdaptive_;
  PixelWindow window_;
  PixelWindow sampledWindow_;  ///< the same, and what it takes to know which pixels differ
  SamplePoints points_;
  Shadings shadings_;
  ProgressiveFilm film_;
  Progress progress_;
  std::size_t sampleCount_ = 0;  ///< of the whole rendering, as far as is known

  std::atomic_flag isPreviewing_ = ATOMIC_FLAG_INIT;
  std::atomic<double> nextPreview_ = settings_.previewSeconds;

  std::mutex totalsMutex_;  ///< guards what follows
  std::size_t committedCount_ = 0;
  std::uint64_t rayCount_ = 0;
  double tracingSeconds_ = 0.0;
  double threadSeconds_ = 0.0;
};

}  // namespace

Rendering renderImage(const Tracer& tracer, const RenderSettings& settings) {
  return ImageRenderer(tracer, settings).render();
}

}  // namespace planetree::render
