#include "import/weld_corners.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace planetree::importing {
namespace {

using Key = std::array<std::uint64_t, 8>;

std::uint64_t bits(double x) noexcept {
  return std::bit_cast<std::uint64_t>(x);
}

Key keyOf(const scene::MeshShape& mesh, std::size_t i) noexcept {
  const Vec3d& p = mesh.positions[i];
  const Vec3d n = mesh.normals.empty() ? Vec3d{} : mesh.normals[i];
  const auto uv = mesh.coordinates.empty() ? std::array<double, 2>{} : mesh.coordinates[i];
  return {bits(p.x), bits(p.y), bits(p.z),   bits(n.x),
          bits(n.y), bits(n.z), bits(uv[0]), bits(uv[1])};
}

/// As in VertexWelder: multiplication by the golden ratio, and the high half folded down.
std::size_t hash(const Key& key) noexcept {
  constexpr std::uint64_t kGoldenRatio = 0x9E37'79B9'7F4A'7C15u;
  std::uint64_t h = 0;
  for (const std::uint64_t word : key) {
    h = (h ^ word) * kGoldenRatio;
    h ^= h >> 32;
  }
  return static_cast<std::size_t>(h);
}

}  // namespace

void weldCorners(scene::MeshShape& mesh) {
  constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();
  const std::size_t count = mesh.positions.size();
  std::vector<std::uint32_t> slots(std::bit_ceil(2 * count + 1), kFree);
  std::vector<std::uint32_t> merged(count);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Key key = keyOf(mesh, i);
    std::size_t slot = hash(key) & (slots.size() - 1);
    while (slots[slot] != kFree && keyOf(mesh, slots[slot]) != key)
      slot = (slot + 1) & (slots.size() - 1);
    if (slots[slot] == kFree) {
      // Vertices move toward the front, over those that are merged already.
      mesh.positions[kept] = mesh.positions[i];
      if (!mesh.normals.empty())
        mesh.normals[kept] = mesh.normals[i];
      if (!mesh.coordinates.empty())
        mesh.coordinates[kept] = mesh.coordinates[i];
      slots[slot] = kept++;
    }
    merged[i] = slots[slot];
  }
  mesh.positions.resize(kept);
  if (!mesh.normals.empty())
    mesh.normals.resize(kept);
  if (!mesh.coordinates.empty())
    mesh.coordinates.resize(kept);
  for (FaceIndices& face : mesh.faces) {
    for (std::uint32_t& vertex : face)
      vertex = merged[vertex];
  }
}

}  // namespace planetree::importing
