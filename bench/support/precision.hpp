#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <cstdint>

/// All rays and answers of the benchmark are in float; an engine may work in double in between.
namespace planetree::bench {

enum class Precision : std::uint8_t { Float, Double };

/// The same mesh in another precision.
template <class T>
[[nodiscard]] TriangleMesh<T> meshIn(const TriangleMesh<float>& mesh) {
  TriangleMesh<T> converted;
  converted.positions.reserve(mesh.positions.size());
  for (const Vec3f& position : mesh.positions)
    converted.positions.push_back(static_cast<Vec3<T>>(position));
  converted.faces = mesh.faces;
  return converted;
}

/// The same ray in another precision.
template <class T>
[[nodiscard]] Ray<T> rayIn(const Rayf& ray) noexcept {
  return {static_cast<Vec3<T>>(ray.origin), static_cast<Vec3<T>>(ray.direction),
          static_cast<T>(ray.tMin), static_cast<T>(ray.tMax)};
}

/// A hit rounded to float.
template <class T>
[[nodiscard]] Hitf inFloat(const Hit<T>& hit) noexcept {
  return {.t = static_cast<float>(hit.t),
          .u = static_cast<float>(hit.u),
          .v = static_cast<float>(hit.v),
          .normal = static_cast<Vec3f>(hit.normal),
          .geometry = hit.geometry,
          .primitive = hit.primitive,
          .part = hit.part,
          .instance = hit.instance};
}

}  // namespace planetree::bench
