#pragma once

#include "scene/ray_format/material_reader.hpp"
#include "scene/ray_format/token_reader.hpp"
#include "scene/scene_description.hpp"

#include <cstdint>

namespace planetree::scene::ray_format {

/// Where in the scene a shape, transform or group stands.
struct Surroundings {
  Affine placement = {};
  std::uint32_t material = MaterialReader::kBlack;
};

/// What stands behind a shape's keyword. `keyword` must be one of `kShapeKeywords`.
[[nodiscard]] PlacedShape readShape(TokenReader& tokens, const Token& keyword,
                                    MaterialReader& materials, const Surroundings& surroundings);

}  // namespace planetree::scene::ray_format
