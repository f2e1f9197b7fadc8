#include <planetree/scene.hpp>

namespace planetree {

template <std::floating_point T>
std::uint32_t Scene<T>::add(TriangleMesh<T> mesh, const GeometryOptions& options) {
  return add(detail::ownedEntry(std::move(mesh)), options);
}

template <std::floating_point T>
std::uint32_t Scene<T>::add(TriangleMeshView<T> mesh, const GeometryOptions& options) {
  return add(detail::viewedEntry(mesh), options);
}

template <std::floating_point T>
std::uint32_t Scene<T>::add(detail::GeometryEntry<T> entry, const GeometryOptions& options) {
  entry.mask = options.mask;
  entry.userPointer = options.userPointer;
  entries_.push_back(std::move(entry));
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

template class Scene<float>;
template class Scene<double>;

}  // namespace planetree
