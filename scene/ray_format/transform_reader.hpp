#pragma once

#include "scene/affine.hpp"
#include "scene/ray_format/token_reader.hpp"

namespace planetree::scene::ray_format {

/// What stands behind a transform's keyword, up to the comma before what is transformed; applied
/// inside `outer`. Singular transforms are errors. `keyword` must be one of `kTransformKeywords`.
[[nodiscard]] Affine readTransform(TokenReader& tokens, const Token& keyword, const Affine& outer);

}  // namespace planetree::scene::ray_format
