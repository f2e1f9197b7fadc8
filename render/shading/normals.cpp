#include "render/shading/normals.hpp"

#include "render/shading/backdrop.hpp"
#include "render/shading/surface_point.hpp"

#include <utility>

namespace planetree::render {

FilmSample Normals::shade(RayCounter& tracer, const Rayf& cameraRay,
                          const DirectionPoints& /*directions*/) const noexcept {
  const auto hit = tracer.findIntersection(cameraRay);
  if (!hit)
    return {};
  const Vec3f half{0.5f, 0.5f, 0.5f};
  return {.value = half + 0.5f * normalTowardViewer(*hit, cameraRay), .coverage = 1.0f};
}

DevelopedImage Normals::develop(const Film& film) const {
  Image image(film.size());
  for (std::uint32_t y = 0; y < image.size.height; ++y) {
    for (std::uint32_t x = 0; x < image.size.width; ++x) {
      const FilmSample& sample = film.at(x, y);
      const Vec3f behind = backdrop(image.size, x, y);
      const Vec3f shown{srgbEncoded(behind.x), srgbEncoded(behind.y), srgbEncoded(behind.z)};
      image.at(x, y) = quantized(sample.value + shown * (1.0f - sample.coverage));
    }
  }
  return {.image = std::move(image), .range = {}};
}

}  // namespace planetree::render
