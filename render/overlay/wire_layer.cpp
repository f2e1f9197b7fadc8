#include "render/overlay/wire_layer.hpp"

#include "render/overlay/line_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace planetree::render {

namespace {

/// How many pixels deep a surface is: a wire that is behind it by less than that lies on it. A cell
/// often touches the surface that it was split along, and a wire there would be hidden or not by
/// rounding alone. A surface that a pixel shows from the side has in it depths that differ by more
/// than the pixel is wide; this allows for a slope of about seventy degrees.
constexpr double kSurfaceThickness = 3.0;

/// A line in the picture. Of a point on a straight line in space, 1 / depth changes evenly along
/// its picture.
struct ProjectedLine {
  Line2 line;
  double inverseDepthA;
  double inverseDepthB;

  [[nodiscard]] double depth(double along) const noexcept {
    return 1.0 / (inverseDepthA + along * (inverseDepthB - inverseDepthA));
  }
};

/// The part of a line in view coordinates, from a (0) to b (1), that can be seen in a picture with
/// a margin around it, or nothing. Clipping by the four sides of the view (Liang and Barsky, "A new
/// concept and method for line clipping", ACM TOG 1984) keeps what is in front of the eye alone: no
/// near plane is needed.
struct Part {
  double begin = 0.0;
  double end = 1.0;
};
std::optional<Part> visiblePart(const Vec3d& a, const Vec3d& b, const Point2& margin) noexcept {
  Part part;
  // A side keeps the points where its function of the view coordinates is not negative.
  const auto clip = [&part](double atA, double atB) {
    if (atA < 0.0 && atB < 0.0)
      part.end = -1.0;
    else if (atA < 0.0)
      part.begin = std::max(part.begin, atA / (atA - atB));
    else if (atB < 0.0)
      part.end = std::min(part.end, atA / (atA - atB));
  };
  clip(margin.x * a.z - a.x, margin.x * b.z - b.x);
  clip(margin.x * a.z + a.x, margin.x * b.z + b.x);
  clip(margin.y * a.z - a.y, margin.y * b.z - b.y);
  clip(margin.y * a.z + a.y, margin.y * b.z + b.y);
  if (!(part.begin <= part.end))
    return std::nullopt;
  return part;
}

std::optional<ProjectedLine> project(const Vec3d& a, const Vec3d& b, const PinholeCamera& camera,
                                     const ImageSize& size, double width) noexcept {
  const Vec3d viewA = camera.viewCoordinates(a);
  const Vec3d viewB = camera.viewCoordinates(b);
  const Point2 margin{1.0 + 2.0 * width / size.width, 1.0 + 2.0 * width / size.height};
  const auto part = visiblePart(viewA, viewB, margin);
  if (!part)
    return std::nullopt;
  const Vec3d begin = viewA + (viewB - viewA) * part->begin;
  const Vec3d end = viewA + (viewB - viewA) * part->end;
  // In the eye itself a line has no picture.
  if (!(begin.z > 0.0 && end.z > 0.0))
    return std::nullopt;
  const auto pixel = [&size](const Vec3d& point) {
    return Point2{(0.5 + 0.5 * point.x / point.z) * size.width,
                  (0.5 - 0.5 * point.y / point.z) * size.height};
  };
  return ProjectedLine{{pixel(begin), pixel(end)}, 1.0 / begin.z, 1.0 / end.z};
}

}  // namespace

void WireLayer::draw(const Vec3d& a, const Vec3d& b, const PinholeCamera& camera,
                     const SurfaceDepths& depths) {
  const auto wire = project(a, b, camera, size_, style_.width);
  if (!wire)
    return;
  const double pixelAtUnitDepth = camera.viewHeight() / size_.height;
  forEachCoveredPixel(wire->line, style_.width, size_,
                      [&](std::uint32_t x, std::uint32_t y, double coverage, double along) {
                        const double depth = wire->depth(along);
                        const double thickness = kSurfaceThickness * pixelAtUnitDepth * depth;
                        const auto covered = static_cast<float>(coverage);
                        const float visible = depths.visiblePart(x, y, depth - thickness);
                        Coverage& pixel = coverages_[index(x, y)];
                        pixel.seen = std::max(pixel.seen, covered * visible);
                        pixel.hidden = std::max(pixel.hidden, covered * (1.0f - visible));
                      });
}

Light WireLayer::light(std::uint32_t x, std::uint32_t y) const noexcept {
  const Coverage& coverage = coverages_[index(x, y)];
  const float alpha = std::max(style_.seen * coverage.seen, style_.hidden * coverage.hidden);
  return {style_.colour * alpha, alpha};
}

}  // namespace planetree::render
