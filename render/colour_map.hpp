#pragma once

#include <planetree/geometry/vec3.hpp>

namespace planetree::render {

/// A colour for a value in [0, 1], as a screen takes it: from black over purple and orange to pale
/// yellow. Equal steps of the value look like equal steps, in print and to colour-blind eyes too.
/// Values outside are clamped; NaN gives the colour of 0.
///
/// It is "inferno" by Nathaniel Smith and Stefan van der Walt ("A better default colormap for
/// matplotlib", SciPy 2015; CC0), interpolated between nine of its colours.
[[nodiscard]] Vec3f infernoColour(float value) noexcept;

}  // namespace planetree::render
