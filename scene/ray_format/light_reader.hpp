#pragma once

#include "scene/ray_format/token_reader.hpp"
#include "scene/scene_description.hpp"

namespace planetree::scene::ray_format {

// What stands behind `light`, the keyword. Several ambient lights add up.
void readAmbientLight(TokenReader& tokens, const Token& light, SceneDescription& scene);
void readPointLight(TokenReader& tokens, const Token& light, SceneDescription& scene);
void readDirectionalLight(TokenReader& tokens, const Token& light, SceneDescription& scene);

}  // namespace planetree::scene::ray_format
