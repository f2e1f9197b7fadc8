#pragma once

#include "render/camera.hpp"
#include "render/image.hpp"
#include "render/rendering.hpp"
#include "render/sample_grid.hpp"
#include "render/tracer.hpp"
#include "render/whitted/whitted.hpp"
#include "scene/build_scene.hpp"
#include "scene/view.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace planetree::render {

/// What a picture shows.
enum class RenderMode { AmbientOcclusion, Normals, Depth, Heat, Whitted, Albedo };

/// What can be chosen about a picture.
struct RenderSettings {
  ImageSize size{800, 600};
  Camera camera;
  /// Takes the place of `camera`, but for the direction up.
  std::optional<scene::View> view = {};
  RenderMode mode = RenderMode::AmbientOcclusion;

  /// Camera rays for each pixel; at least 1. Powers of two are spread best.
  std::uint32_t samplesPerPixel = 8;
  std::uint64_t seed = 0;
  /// Takes the place of `samplesPerPixel` and, for where they are in a pixel, of `seed`.
  std::optional<SampleGrid> grid = {};

  /// The part to render, within the picture; unset, all of it. Its pixels are those that the whole
  /// picture has there.
  std::optional<PixelWindow> crop = {};

  /// 0 means as many as the machine has. The picture is the same for any number.
  std::uint32_t threadCount = 0;

  /// The scene whose tree the tracer has, if it has materials. It must outlive the rendering, and
  /// must be there for `Whitted` and `Albedo`.
  const scene::BuiltScene* scene = nullptr;
  WhittedSettings whitted = {};

  /// The colours of the geometries for ambient occlusion where there is no scene, in linear light;
  /// see AmbientOcclusion.
  std::vector<Vec3f> albedos = {};
  /// `Normals` are those of the scene: interpolated where a mesh has some at its corners.
  bool hasShadingNormals = false;

  /// The steps that the brightest colour of `Heat` stands for, so that pictures can be compared.
  /// Positive; unset, the picture itself decides.
  std::optional<double> heatMax = {};

  /// Draws the cells of the tree at this depth, from 1, and the leaves above it.
  std::optional<std::uint32_t> cellDepth = {};

  /// `Whitted` brings the albedo, the normal and the depth of what each ray sees first.
  bool hasLayers = false;

  /// All pixels get some samples before any of them gets all, so that there is something to look at
  /// early. The picture is the same in the end.
  bool isProgressive = false;
  /// Called with what there is so far, every `previewSeconds` or so, by a rendering thread, but
  /// never twice at a time. The others go on meanwhile.
  std::function<void(const Rendering&)> onPreview = {};
  double previewSeconds = 10.0;

  /// Called often with the part of the picture that is done, from 0 to 1, by all rendering threads
  /// and several at once. If it returns false, rendering stops soon.
  std::function<bool(double done)> keepsGoing = {};
};

/// The picture of what `tracer` answers for, or what there is of it when it was stopped. The size
/// must not be zero, and the camera must look at another point than its own. Throws what
/// `onPreview` throws.
[[nodiscard]] Rendering renderImage(const Tracer& tracer, const RenderSettings& settings);

}  // namespace planetree::render
