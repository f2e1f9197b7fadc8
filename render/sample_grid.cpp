#include "render/sample_grid.hpp"

namespace planetree::render {

Point2 gridPoint(const SampleGrid& grid, std::uint32_t sample) noexcept {
  const auto side = static_cast<double>(grid.side);
  // Pixels are counted from the top, rows of the grid from below.
  return {sample % grid.side / side, 1.0 - sample / grid.side / side};
}

}  // namespace planetree::render
