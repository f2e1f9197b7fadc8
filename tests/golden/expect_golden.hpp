#pragma once

#include "render/image.hpp"

#include <string>

namespace planetree::test {

/// Compares a picture with the one of this name in data/golden. `tolerance` is how far it may be
/// from it: the root of the mean square difference of the channels, in steps of 1/255.
///
/// After a change that is meant to alter pictures, look at the new ones and keep them:
///
///     PLANETREE_UPDATE_GOLDENS=1 <build folder>/bin/golden
///
/// A picture that differs is left in the build folder for comparison.
void expectGolden(const render::Image& actual, const std::string& name, double tolerance);

}  // namespace planetree::test
