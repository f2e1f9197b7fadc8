#include "mesh/pack_leaf.hpp"

#include <array>
#include <type_traits>

namespace planetree::detail {

template <class T>
bool FacePacker<T>::open(std::span<const std::uint32_t> objects) {
  triangles_.clear();
  for (const std::uint32_t object : objects) {
    const GeometryEntry<T>& geometry = geometries_[geometryOf(geometries_, object)];
    if (!isTriangleMesh(geometry))
      return false;
    const auto& mesh = *static_cast<const TriangleMeshView<T>*>(geometry.range);
    const std::array<Vec3<T>, 3> corners = mesh.corners(object - geometry.firstObject);
    if constexpr (std::is_same_v<T, float>) {
      triangles_.add(corners, object);
    } else {
      triangles_.add(
          {static_cast<Vec3f>(corners[0] - center_), static_cast<Vec3f>(corners[1] - center_),
           static_cast<Vec3f>(corners[2] - center_)},
          object);
    }
  }
  return true;
}

template class FacePacker<float>;
template class FacePacker<double>;

}  // namespace planetree::detail
