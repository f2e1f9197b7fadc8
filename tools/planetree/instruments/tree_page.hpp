#pragma once

#include "instruments/tree_account.hpp"

#include <string>

namespace planetree::tool {

/// The tree on a page of text for people, at most 100 columns wide: the numbers, and charts of its
/// levels and of its leaves.
[[nodiscard]] std::string treePage(const TreeAccount& account);

}  // namespace planetree::tool
