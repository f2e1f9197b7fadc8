#include "bench/scene/write_ply.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>

namespace planetree::bench {

namespace {

/// Least significant byte first, whatever the machine's own order.
void append(std::string& bytes, std::uint32_t word) {
  for (unsigned shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<char>((word >> shift) & 0xFFu));
}

void append(std::string& bytes, float value) {
  append(bytes, std::bit_cast<std::uint32_t>(value));
}

}  // namespace

std::string plyBytes(const TriangleMesh<float>& mesh) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float "
      "y\n"
      "property float z\nelement face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      mesh.positions.size(), mesh.faces.size());
  bytes.reserve(bytes.size() + 12 * mesh.positions.size() + 13 * mesh.faces.size());
  for (const Vec3f& position : mesh.positions) {
    for (const Axis axis : kAxes)
      append(bytes, position[axis]);
  }
  for (const FaceIndices& face : mesh.faces) {
    bytes.push_back(3);
    for (const std::uint32_t vertex : face)
      append(bytes, vertex);
  }
  return bytes;
}

}  // namespace planetree::bench
