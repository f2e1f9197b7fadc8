#pragma once

#include <span>

namespace planetree::importing {

/// An array of assimp: what it says of the length holds only where there is an array.
template <class Item>
[[nodiscard]] std::span<Item> items(Item* first, unsigned count) noexcept {
  return first ? std::span<Item>(first, count) : std::span<Item>();
}

}  // namespace planetree::importing
