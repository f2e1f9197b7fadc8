#pragma once

#include "scene/affine.hpp"
#include "scene/json_format/json_text.hpp"
#include "scene/json_format/json_value.hpp"

namespace planetree::scene::json_format {

/// The map that a list of steps is, the first of them done first. Throws `Error` at the step that
/// is singular.
[[nodiscard]] Affine readTransform(const JsonText& text, const Value& value);

}  // namespace planetree::scene::json_format
