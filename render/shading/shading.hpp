#pragma once

#include "render/film.hpp"
#include "render/image.hpp"
#include "render/sample_points.hpp"
#include "render/tracer.hpp"

#include <planetree/geometry/ray.hpp>

#include <optional>

namespace planetree::render {

/// What the darkest and the brightest colour of a picture stand for.
struct ValueRange {
  double darkest = 0.0;
  double brightest = 0.0;
  double highest = 0.0;  ///< the highest value of any pixel; `brightest` may be below it
};

/// A picture and, if its colours measure something, what they mean.
struct DevelopedImage {
  Image image;
  std::optional<ValueRange> range;
};

/// A way to turn rays into a picture, in two steps: what each camera ray sees, then which colours
/// the pixels get. The second step knows all pixels, so it can choose a range of values.
class Shading {
 public:
  virtual ~Shading() = default;

  /// What one camera ray sees. Whatever the shading has to choose at random it chooses by
  /// `directions`. Any thread may call it.
  [[nodiscard]] virtual FilmSample shade(RayCounter& tracer, const Rayf& cameraRay,
                                         const DirectionPoints& directions) const noexcept = 0;

  [[nodiscard]] virtual DevelopedImage develop(const Film& film) const = 0;
};

}  // namespace planetree::render
