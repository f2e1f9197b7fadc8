#pragma once

#include "scene/json_format/json_text.hpp"
#include "scene/json_format/json_value.hpp"

#include <cstddef>

namespace planetree::scene::json_format {

/// Deeper than any scene is built by hand, and shallow enough to walk by recursion.
inline constexpr std::size_t kMaxGroupDepth = 100;
/// Two levels for the scene and its shapes, two for each group, and in the innermost one that of a
/// shape and four for the axis in a step of its transform.
inline constexpr std::size_t kMaxNestingDepth = 2 + 2 * kMaxGroupDepth + 5;
/// Keeps what is made of a file in proportion to it: values take more memory than their text.
inline constexpr std::size_t kMaxValueCount = std::size_t{1} << 22u;

/// The value that the text is. Throws `Error` with line and column: `MalformedFile` for what is not
/// JSON, nested deeper than `kMaxNestingDepth`, or has a key twice in one object;
/// `CapacityExceeded` for more than `kMaxValueCount` values.
[[nodiscard]] Value parseJson(const JsonText& text);

}  // namespace planetree::scene::json_format
