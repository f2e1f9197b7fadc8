#pragma once

#include "json_text.hpp"

#include "instruments/walk_page.hpp"

#include <planetree/traversal/walk.hpp>

#include <concepts>

namespace planetree::tool {

/// The walk as members of a JSON document; docs/instruments.md lists them. All numbers keep their
/// bits, and null stands for infinity.
template <std::floating_point T>
[[nodiscard]] Json walkJson(const Walk<T>& walk, const WalkContext& context);

extern template Json walkJson<float>(const Walk<float>&, const WalkContext&);
extern template Json walkJson<double>(const Walk<double>&, const WalkContext&);

}  // namespace planetree::tool
