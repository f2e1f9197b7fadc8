#pragma once

#include "import/assimp/message_writer.hpp"

struct aiScene;

namespace planetree::importing {

/// Thrown where a scene has more vertices than 32 bits can count.
struct TooManyVertices {};

/// Sends each mesh of the scene as often as its nodes place it, in world coordinates. What assimp
/// hands over is checked as far as it says how large it is: it may be wrong after a bad file.
void sendScene(const aiScene& scene, MessageWriter& writer);

}  // namespace planetree::importing
