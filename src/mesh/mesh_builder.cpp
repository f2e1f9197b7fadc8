#include "mesh/mesh_builder.hpp"

#include <algorithm>
#include <limits>

namespace planetree::detail {
namespace {

/// Polygons that are named in the report; the rest is only counted.
constexpr std::size_t kNamedSkips = 16;

/// Vertices and faces are counted with 32 bits; the last value is left to mean none.
constexpr std::uint64_t kMaxCount = std::numeric_limits<std::uint32_t>::max();

}  // namespace

template <std::floating_point T>
std::uint32_t MeshBuilder<T>::addVertex(const Vec3<T>& position) {
  const std::size_t index = mesh_.positions.size();
  if (index == kMaxCount)
    throw tooMany("vertices");
  mesh_.positions.push_back(position);
  return static_cast<std::uint32_t>(index);
}

template <std::floating_point T>
void MeshBuilder<T>::addPolygon(std::span<const std::int64_t> corners, std::int64_t line) {
  if (corners.size() < 3)
    return skipPolygon("has fewer than three corners", line);
  corners_.clear();
  for (const std::int64_t corner : corners) {
    if (!isVertex(corner))
      return skipPolygon(missingVertexReason(corner), line);
    corners_.push_back(static_cast<std::uint32_t>(corner));
  }
  const std::uint64_t triangleCount = corners.size() - 2;
  if (triangleCount > kMaxCount - mesh_.faces.size())
    throw tooMany("triangles");
  if (report_.polygonCount == kMaxCount)
    throw tooMany("polygons");
  mesh_.addPolygon(corners_, static_cast<std::uint32_t>(report_.polygonCount));
  ++report_.polygonCount;
}

template <std::floating_point T>
void MeshBuilder<T>::skipPolygon(const std::string& reason, std::int64_t line) {
  if (report_.skipped.size() < kNamedSkips) {
    report_.skipped.push_back({report_.polygonCount, line, reason});
  }
  ++report_.skippedPolygonCount;
  ++report_.polygonCount;
}

template <std::floating_point T>
bool MeshBuilder<T>::isVertex(std::int64_t index) const noexcept {
  const std::uint64_t count =
      std::max<std::uint64_t>(announcedVertexCount_, mesh_.positions.size());
  return index >= 0 && static_cast<std::uint64_t>(index) < std::min(count, kMaxCount);
}

template <std::floating_point T>
Error MeshBuilder<T>::tooMany(const std::string& what) const {
  return Error(ErrorCode::CapacityExceeded,
               "it has more than " + std::to_string(kMaxCount) + " " + what,
               "Divide the model into several files", Error::Place{input_->name});
}

template class MeshBuilder<float>;
template class MeshBuilder<double>;

std::string missingVertexReason(std::int64_t index) {
  return "refers to vertex " + std::to_string(index) + ", which does not exist";
}

}  // namespace planetree::detail
