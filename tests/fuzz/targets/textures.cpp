#include "scene/texture.hpp"

#include "support/promise.hpp"

#include <planetree/error.hpp>

#include <cstdint>
#include <span>
#include <string>

// Images for surfaces.

namespace planetree::fuzz {
namespace {

constexpr const char* kFile = "image.png";

void requireColour(const Vec3d& colour) {
  for (const Axis axis : kAxes)
    require(colour[axis] >= 0.0 && colour[axis] <= 1.0, "colours are within [0, 1]");
}

void check(const scene::Texture& texture) {
  require(texture.width() > 0 && texture.height() > 0, "a texture has texels");
  requireColour(Vec3d(texture.texel(0, 0)));
  requireColour(Vec3d(texture.texel(texture.width() - 1, texture.height() - 1)));
  for (const double u : {-1e300, -0.5, 0.0, 0.3, 1.0, 7.0}) {
    for (const scene::TextureEdges edges :
         {scene::TextureEdges::Repeated, scene::TextureEdges::Wrapped,
          scene::TextureEdges::Clamped})
      requireColour(texture.at(u, 1.0 - u, edges));
  }
}

}  // namespace
}  // namespace planetree::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace planetree;
  try {
    fuzz::check(scene::readTexture(std::as_bytes(std::span(data, size)), fuzz::kFile));
  } catch (const Error& error) {
    const auto details = [&error] { return std::string(error.what()); };
    fuzz::require(error.file() == fuzz::kFile, "an error names the file", details);
    fuzz::require(!error.advice().empty(), "an error gives advice", details);
    fuzz::require(error.code() == ErrorCode::MalformedFile ||
                      error.code() == ErrorCode::UnknownFormat ||
                      error.code() == ErrorCode::CapacityExceeded,
                  "what cannot be read is malformed, unknown or too large", details);
  }
  return 0;
}
