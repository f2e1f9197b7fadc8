#include "bench/render/ray_mesh.hpp"

#include "bench/scene/generated_scenes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <iterator>

namespace planetree::bench {

TriangleMesh<float> makeRayMesh(std::size_t faceCount) {
  const double squares = std::ceil(std::sqrt(static_cast<double>(faceCount) / 2.0));
  TriangleMesh<float> mesh = makeTerrain(static_cast<std::uint32_t>(squares));
  mesh.faces.resize(faceCount);
  return mesh;
}

std::string rayText(const TriangleMesh<float>& mesh) {
  std::string text = "SBT-raytracer 1.0\ntrimesh {\n  points = (";
  const auto append = std::back_inserter(text);
  const char* separator = "\n    ";
  for (const auto& [x, y, z] : mesh.positions) {
    fmt::format_to(append, "{}({}, {}, {})", separator, x, y, z);
    separator = ",\n    ";
  }
  text += ");\n  faces = (";
  separator = "\n    ";
  for (const auto& [a, b, c] : mesh.faces) {
    fmt::format_to(append, "{}({}, {}, {})", separator, a, b, c);
    separator = ",\n    ";
  }
  return text + ");\n  gennormals;\n}\n";
}

}  // namespace planetree::bench
