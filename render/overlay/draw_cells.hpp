#pragma once

#include "render/camera.hpp"
#include "render/overlay/wire_layer.hpp"
#include "render/parallel_tiles.hpp"
#include "render/tracer.hpp"

#include <cstdint>
#include <optional>

namespace planetree::render {

/// Which cells of a tree to draw, and how.
struct CellSettings {
  ImageSize size;
  std::uint32_t depth = 1;  ///< as in cell_edges.hpp
  Vec3f colour = {};        ///< in linear light
  std::uint32_t threadCount = 0;
};

/// How many rays each pixel of a picture of cells takes.
inline constexpr std::uint32_t kRaysPerCellPixel = kDepthPlaces.size();

/// The cells of a tree as wires, hidden by what the tree holds; nothing if `progress`, which counts
/// the pixels, was stopped.
[[nodiscard]] std::optional<WireLayer> drawCells(const Tracer& tracer, const PinholeCamera& camera,
                                                 const CellSettings& settings, Progress& progress);

}  // namespace planetree::render
