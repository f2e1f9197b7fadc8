#pragma once

#include "render/file/channel_image.hpp"
#include "render/film.hpp"
#include "render/image.hpp"
#include "render/overlay/wire_layer.hpp"
#include "render/shading/shading.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace planetree::render {

/// What else is known of the pixels of a picture.
struct RenderedLayer {
  Film film;
  std::vector<Measurement> measurements;
};

/// A picture and what it took.
struct Rendering {
  Film film;           ///< of the window alone
  PixelWindow window;  ///< in the whole picture
  ImageSize wholeSize;
  Development development;
  std::vector<RenderedLayer> layers;
  std::optional<ValueRange> range;  ///< what the colours of `Depth` and `Heat` stand for
  std::optional<WireLayer> cells;   ///< of the whole picture

  bool isComplete = false;  ///< not if rendering was stopped, or goes on
  double done = 0.0;        ///< the part of the samples that the film has, from 0 to 1

  std::uint64_t rayCount = 0;
  double seconds = 0.0;  ///< tracing and shading, without the choice of colours
  /// The same as all threads together took: waiting for the tree's answers, and all else.
  double tracingSeconds = 0.0;
  double shadingSeconds = 0.0;
};

/// A rendering as a screen shows it: the cells, the picture, and the backdrop behind it.
[[nodiscard]] Image shownImage(const Rendering& rendering);

/// A rendering in numbers. R, G, B and A are the picture in linear light, A being the part of the
/// pixel that is covered, by which the others are multiplied; there is no backdrop. What the mode
/// measures follows, then its layers, and then the cells, as a layer of their own: nothing is
/// painted over data.
[[nodiscard]] ChannelImage channelImage(const Rendering& rendering);

}  // namespace planetree::render
