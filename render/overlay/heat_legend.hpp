#pragma once

#include "render/image.hpp"
#include "render/shading/shading.hpp"

#include <string>
#include <vector>

namespace planetree::render {

/// A mark on a scale.
struct Tick {
  double value = 0.0;
  std::string label;
};

/// The marks of a scale from 0 to `brightest`, both ends included: round numbers between, so many
/// that their labels fit if the scale is as wide as this many labels. If the scale ends before the
/// highest value, the last label has a plus.
[[nodiscard]] std::vector<Tick> scaleTicks(const ValueRange& range, int labelCount);

/// The picture of `Heat` with a legend below it: what is counted; the lowest, mean and highest
/// pixel; and a bar of all colours with the steps that they stand for, which ends in an arrow if
/// there are pixels beyond its end. The picture itself stays as it is. One that is too narrow for
/// the legend stands in the middle above it.
[[nodiscard]] Image withHeatLegend(const Image& picture, const ValueRange& range);

}  // namespace planetree::render
