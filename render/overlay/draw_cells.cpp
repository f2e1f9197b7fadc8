#include "render/overlay/draw_cells.hpp"

#include "render/overlay/cell_edges.hpp"

#include <algorithm>

namespace planetree::render {

namespace {

/// Lines are as wide as this part of a picture's height, and never thinner than a pixel.
constexpr double kLineWidth = 1.0 / 600.0;

/// How often drawing asks whether it is still wanted.
constexpr std::size_t kEdgesBetweenQuestions = 4096;

void traceDepths(const Tracer& tracer, const PinholeCamera& camera, const Tile& tile,
                 SurfaceDepths& depths) {
  const ImageSize& size = depths.size();
  const Vec3f forward(camera.axes().forward);
  for (std::uint32_t y = tile.firstY; y < tile.endY; ++y) {
    for (std::uint32_t x = tile.firstX; x < tile.endX; ++x) {
      SurfaceDepths::Depths& pixel = depths.at(x, y);
      for (std::size_t i = 0; i < kDepthPlaces.size(); ++i) {
        const Rayf ray =
            camera.ray((x + kDepthPlaces[i].x) / size.width, (y + kDepthPlaces[i].y) / size.height);
        if (const auto hit = tracer.findIntersection(ray))
          pixel[i] = hit->t * dot(ray.direction, forward);
      }
    }
  }
}

}  // namespace

std::optional<WireLayer> drawCells(const Tracer& tracer, const PinholeCamera& camera,
                                   const CellSettings& settings, Progress& progress) {
  SurfaceDepths depths(settings.size);
  forEachTile(settings.size, settings.threadCount, [&](const Tile& tile) {
    if (progress.isStopped())
      return;
    traceDepths(tracer, camera, tile, depths);
    progress.add(static_cast<std::size_t>(tile.endX - tile.firstX) * (tile.endY - tile.firstY));
  });

  WireLayer wires(settings.size, {.colour = settings.colour,
                                  .width = std::max(1.0, kLineWidth * settings.size.height)});
  std::size_t edgeCount = 0;
  forEachCellEdge(tracer.nodes(), tracer.bounds(), settings.depth, [&](const CellEdge& edge) {
    if (++edgeCount % kEdgesBetweenQuestions == 0)
      progress.add(0);
    if (!progress.isStopped())
      wires.draw(Vec3d(edge.a), Vec3d(edge.b), camera, depths);
  });
  if (progress.isStopped())
    return std::nullopt;
  return wires;
}

}  // namespace planetree::render
