#pragma once

#include "render/camera.hpp"
#include "render/file/channel_image.hpp"
#include "render/film.hpp"
#include "render/image.hpp"
#include "render/overlay/wire_layer.hpp"
#include "render/shading/shading.hpp"
#include "render/tracer.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace planetree::render {

/// What a picture shows.
enum class RenderMode { AmbientOcclusion, Normals, Depth, Heat };

/// What can be chosen about a picture.
struct RenderSettings {
  ImageSize size{800, 600};
  Camera camera;
  RenderMode mode = RenderMode::AmbientOcclusion;

  /// Camera rays for each pixel; at least 1. Powers of two are spread best.
  std::uint32_t samplesPerPixel = 8;
  std::uint64_t seed = 0;

  /// 0 means as many as the machine has. The picture is the same for any number.
  std::uint32_t threadCount = 0;

  /// The colours of the geometries for ambient occlusion, in linear light; see AmbientOcclusion.
  std::vector<Vec3f> albedos = {};

  /// The steps that the brightest colour of `Heat` stands for, so that pictures can be compared.
  /// Positive; unset, the picture itself decides.
  std::optional<double> heatMax = {};

  /// Draws the cells of the tree at this depth, from 1, and the leaves above it.
  std::optional<std::uint32_t> cellDepth = {};

  /// Called often with the part of the picture that is done, from 0 to 1, by all rendering threads
  /// and several at once. If it returns false, rendering stops soon.
  std::function<bool(double done)> keepsGoing = {};
};

/// A picture and what it took.
struct Rendering {
  Film film;
  Development development;
  std::optional<ValueRange> range;  ///< what the colours of `Depth` and `Heat` stand for
  std::optional<WireLayer> cells;
  std::uint64_t rayCount = 0;
  double seconds = 0.0;  ///< tracing, without the choice of colours
};

/// The picture of what `tracer` answers for; nothing if it was stopped. The size must not be zero,
/// and the camera must look at another point than its own.
[[nodiscard]] std::optional<Rendering> renderImage(const Tracer& tracer,
                                                   const RenderSettings& settings);

/// A rendering as a screen shows it: the cells, the picture, and the backdrop behind it.
[[nodiscard]] Image shownImage(const Rendering& rendering);

/// A rendering in numbers. R, G, B and A are the picture in linear light, A being the part of the
/// pixel that is covered, by which the others are multiplied; there is no backdrop. What the mode
/// measures follows, and then the cells, as a layer of their own: nothing is painted over data.
[[nodiscard]] ChannelImage channelImage(const Rendering& rendering);

}  // namespace planetree::render
