#pragma once

#include "render/camera.hpp"
#include "render/image.hpp"
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

  /// Called often with the part of the picture that is done, from 0 to 1, by all rendering threads
  /// and several at once. If it returns false, rendering stops soon.
  std::function<bool(double done)> keepsGoing = {};
};

/// A picture and what it took.
struct Rendering {
  Image image;
  std::optional<ValueRange> range;  ///< what the colours of `Depth` and `Heat` stand for
  std::uint64_t rayCount = 0;
  double seconds = 0.0;  ///< tracing, without the choice of colours
};

/// The picture of what `tracer` answers for; nothing if it was stopped. The size must not be zero,
/// and the camera must look at another point than its own.
[[nodiscard]] std::optional<Rendering> renderImage(const Tracer& tracer,
                                                   const RenderSettings& settings);

}  // namespace planetree::render
