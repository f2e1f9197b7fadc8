#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/traversal/walk.hpp>

#include <concepts>
#include <cstdint>
#include <span>
#include <string>

namespace planetree::tool {

/// What is to be known of a walk through the tree of one mesh beside the walk itself.
struct WalkContext {
  bool isAnyHit = false;  ///< the search was content with any hit
  Box3 bounds = {};       ///< of the tree
  /// The face of the file that each triangle was cut from; empty where that is the same number.
  std::span<const std::uint32_t> sourceFaces = {};
};

/// The walk on a page of text for people, at most 100 columns wide. The ray and the hit are printed
/// to the last bit, all else to six digits.
template <std::floating_point T>
[[nodiscard]] std::string walkPage(const Walk<T>& walk, const WalkContext& context);

extern template std::string walkPage<float>(const Walk<float>&, const WalkContext&);
extern template std::string walkPage<double>(const Walk<double>&, const WalkContext&);

}  // namespace planetree::tool
