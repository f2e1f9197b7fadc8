#pragma once

#include "render/file/channel_image.hpp"
#include "render/film.hpp"
#include "render/light.hpp"
#include "render/sample_points.hpp"
#include "render/tracer.hpp"

#include <planetree/geometry/ray.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace planetree::render {

/// What the darkest and the brightest colour of a picture stand for, and what its pixels have.
struct ValueRange {
  double darkest = 0.0;
  double brightest = 0.0;
  double lowest = 0.0;   ///< of any pixel
  double mean = 0.0;     ///< over all pixels that have a value
  double highest = 0.0;  ///< of any pixel; the colours may end before it
};

/// Something measured in each pixel, beside its colour.
struct Measurement {
  std::string channel;  ///< its name in a file of channels
  std::function<float(const FilmSample&)> value;
  ChannelType type = ChannelType::Float;
};

/// How the pixels of one film are to be shown.
struct Development {
  std::function<Light(const FilmSample&)> light;
  bool hasBackdrop = false;  ///< what nothing covers is not black
  bool isEncoded = false;    ///< the colours are for the screen as they are, not in linear light
  std::vector<Measurement> measurements;
  std::optional<ValueRange> range;  ///< if the colours measure something
};

/// Camera rays that are traced together, and for each of them the points to choose directions by.
struct CameraRays {
  std::vector<Rayf> rays;
  std::vector<DirectionPoints> directions;
  std::optional<std::vector<Hitf>> firstHits = {};  ///< kept by `hits`

  /// What each ray hits first. It is traced once, whichever shadings ask.
  [[nodiscard]] const std::vector<Hitf>& hits(RayCounter& tracer) {
    if (!firstHits)
      firstHits = tracer.findIntersections(rays);
    return *firstHits;
  }
};

/// A way to turn rays into a picture, in two steps: what each camera ray sees, then which colours
/// the pixels get. The second step knows all pixels, so it can choose a range of values.
class Shading {
 public:
  virtual ~Shading() = default;

  /// What each camera ray sees; it does not depend on which rays come with it. Whatever the shading
  /// has to choose at random it chooses by their `directions`. Any thread may call it.
  [[nodiscard]] virtual std::vector<FilmSample> shade(RayCounter& tracer,
                                                      CameraRays& camera) const = 0;

  /// The answer does not refer to the shading or to the film.
  [[nodiscard]] virtual Development develop(const Film& film) const = 0;
};

}  // namespace planetree::render
