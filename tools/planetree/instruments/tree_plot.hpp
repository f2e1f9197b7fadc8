#pragma once

#include "instruments/tree_account.hpp"

#include <string>

namespace planetree::tool {

/// Charts of the tree's levels and leaf sizes as an SVG picture that stands on its own: no fonts,
/// scripts or files are fetched. It has a light and a dark form, and says what it shows to those
/// who cannot see it.
[[nodiscard]] std::string treePlot(const TreeAccount& account);

}  // namespace planetree::tool
