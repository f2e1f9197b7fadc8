#include "render/rendering.hpp"

#include "render/shading/backdrop.hpp"

#include <array>
#include <cstddef>
#include <string>

namespace planetree::render {

namespace {

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

void addMeasurements(ChannelImage& image, const Film& film,
                     const std::vector<Measurement>& measurements) {
  for (const Measurement& measurement : measurements) {
    Channel& channel = image.channels.emplace_back(
        Channel{.name = measurement.channel, .type = measurement.type, .values = {}});
    channel.values.reserve(film.samples().size());
    for (const FilmSample& sample : film.samples())
      channel.values.push_back(measurement.value(sample));
  }
}

}  // namespace

Image shownImage(const Rendering& rendering) {
  const ImageSize size = rendering.film.size();
  const PixelWindow& window = rendering.window;
  Image image(size);
  for (std::uint32_t y = 0; y < size.height; ++y) {
    for (std::uint32_t x = 0; x < size.width; ++x) {
      Light light = rendering.development.light(rendering.film.at(x, y));
      if (rendering.development.hasBackdrop)
        light = over(light, {backdrop(rendering.wholeSize, window.x + x, window.y + y), 1.0f});
      if (rendering.cells)
        light = over(rendering.cells->light(window.x + x, window.y + y), light);
      image.at(x, y) =
          quantized(rendering.development.isEncoded ? light.colour : srgbEncoded(light.colour));
    }
  }
  return image;
}

ChannelImage channelImage(const Rendering& rendering) {
  const Film& film = rendering.film;
  ChannelImage image{.size = film.size(),
                     .channels = {},
                     .firstX = rendering.window.x,
                     .firstY = rendering.window.y,
                     .wholeSize = rendering.wholeSize};
  addColours(image, "", [&](std::uint32_t x, std::uint32_t y) {
    Light light = rendering.development.light(film.at(x, y));
    if (rendering.development.isEncoded)
      light.colour = srgbDecoded(light.colour);
    return light;
  });
  addMeasurements(image, film, rendering.development.measurements);
  for (const RenderedLayer& layer : rendering.layers)
    addMeasurements(image, layer.film, layer.measurements);
  if (rendering.cells) {
    addColours(image, "cells.", [&](std::uint32_t x, std::uint32_t y) {
      return rendering.cells->light(rendering.window.x + x, rendering.window.y + y);
    });
  }
  return image;
}

}  // namespace planetree::render
