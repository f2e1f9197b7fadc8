#include <planetree/mesh/triangle_mesh.hpp>

#include <numeric>

namespace planetree {

template <std::floating_point T>
void TriangleMesh<T>::addPolygon(std::span<const std::uint32_t> corners, std::uint32_t source) {
  if (corners.size() < 3)
    return;
  const std::size_t triangleCount = corners.size() - 2;
  const bool isOwnSource = triangleCount == 1 && source == faces.size();
  if (sourceFaces.empty() && !isOwnSource) {
    sourceFaces.resize(faces.size());
    std::iota(sourceFaces.begin(), sourceFaces.end(), 0u);
  }
  const bool keepsSources = !sourceFaces.empty() || !isOwnSource;
  for (std::size_t i = 0; i < triangleCount; ++i) {
    faces.push_back({corners[0], corners[i + 1], corners[i + 2]});
    if (keepsSources)
      sourceFaces.push_back(source);
  }
}

template struct TriangleMesh<float>;
template struct TriangleMesh<double>;

}  // namespace planetree
