#include "render/overlay/draw_cells.hpp"

#include "render/overlay/cell_edges.hpp"
#include "render/shading/surface_point.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

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
  std::vector<Rayf> rays;
  for (std::uint32_t y = tile.firstY; y < tile.endY; ++y) {
    for (std::uint32_t x = tile.firstX; x < tile.endX; ++x) {
      for (const Point2& place : kDepthPlaces)
        rays.push_back(camera.ray((x + place.x) / size.width, (y + place.y) / size.height));
    }
  }
  const std::vector<Hitf> hits = tracer.findIntersections(rays);
  std::size_t next = 0;
  for (std::uint32_t y = tile.firstY; y < tile.endY; ++y) {
    for (std::uint32_t x = tile.firstX; x < tile.endX; ++x) {
      for (float& depth : depths.at(x, y)) {
        if (isSurface(hits[next]))
          depth = hits[next].t * dot(rays[next].direction, forward);
        ++next;
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
