#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include "soak/closed_solids.hpp"
#include "support/hard_cases.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// Meshes, and rays at them that are hard to judge: they pass within a few roundoffs of edges, of
/// vertices and of the ends of intervals, or in the planes of triangles.
namespace planetree::test {

template <class T>
struct JudgedSet {
  std::string name;
  TriangleMesh<T> mesh;
};

namespace detail {

/// Triangles with one or two sides as short as 2^-26 of the others.
template <class T>
TriangleMesh<T> needles(std::uint64_t salt, int count) {
  Random random(salt);
  TriangleMesh<T> mesh;
  for (int i = 0; i < count; ++i) {
    const auto a = random.pointIn<double>({-1, -1, -1}, {1, 1, 1});
    const Vec3d along = random.direction() * random.between(0.2, 2.0);
    const Vec3d aside = random.direction() * std::exp2(random.between(-26.0, -6.0));
    const Vec3d c = random.chance(0.5) ? a + aside : a + along * random.unit() + aside;
    addTriangle(mesh, static_cast<Vec3<T>>(a), static_cast<Vec3<T>>(a + along),
                static_cast<Vec3<T>>(c));
  }
  return mesh;
}

/// Sheets a few ulps apart: which of them is nearer is a question of rounding.
template <class T>
TriangleMesh<T> sheets(int count) {
  TriangleMesh<T> mesh;
  T height = T(0.3);
  for (int i = 0; i < count; ++i) {
    TriangleMesh<T> sheet =
        grid<T>(2, {-1, -1, static_cast<double>(height)}, {2, 0, 0.3}, {0, 2, 0.7});
    append(mesh, sheet);
    for (int ulps = 0; ulps < 1 << (i % 4); ++ulps)
      height = std::nextafter(height, T(1));
  }
  return mesh;
}

/// A step of up to so many ulps up or down, small ones as often as large ones.
template <class T>
T nudged(T value, int mostBits, Random& random) {
  const double ulps = std::exp2(random.between(0.0, mostBits)) * (random.chance(0.5) ? 1.0 : -1.0);
  const double ulp = std::fabs(static_cast<double>(value)) *
                     static_cast<double>(std::numeric_limits<T>::epsilon());
  return static_cast<T>(static_cast<double>(value) + ulps * ulp);
}

}  // namespace detail

/// The shared list of hard cases, and more soups, slivers and closed solids.
template <class T>
std::vector<JudgedSet<T>> judgedSets() {
  std::vector<JudgedSet<T>> sets;
  for (HardMesh<T>& hard : hardMeshes<T>())
    sets.push_back({std::move(hard.name), std::move(hard.mesh)});
  sets.push_back({"needles", detail::needles<T>(601, 200)});
  sets.push_back({"sheets a few ulps apart", detail::sheets<T>(12)});
  sets.push_back({"large soup", detail::soup<T>(602, 1500, 0.1)});
  for (PlacedSolid<T>& solid : placedSolids<T>()) {
    if (solid.mesh.faces.size() < 700)
      sets.push_back({solid.name + ", " + solid.placement, std::move(solid.mesh)});
  }
  return sets;
}

/// The same ray with a direction as short or long as docs/limits.md allows, by a power of two.
template <class T>
Ray<T> withAnyLength(Ray<T> ray, Random& random) {
  const double size = length(static_cast<Vec3d>(ray.direction));
  if (!(size > 0.0))
    return ray;
  const auto factor =
      static_cast<T>(std::exp2(std::round(random.between(-59.0, 58.0) - std::log2(size))));
  ray.direction = ray.direction * factor;
  ray.tMin = ray.tMin / factor;
  ray.tMax = ray.tMax / factor;
  return ray;
}

/// Aimed at a feature of a face, and moved aside by a few ulps, or not.
template <class T>
Ray<T> nearMiss(const TriangleMesh<T>& mesh, const FaceIndices& face, double extent,
                Random& random) {
  const std::size_t first = random.below(3);
  const auto corner = [&](std::size_t i) {
    return static_cast<Vec3d>(mesh.positions[face[(first + i) % 3]]);
  };
  const Vec3d a = corner(0);
  const Vec3d ab = corner(1) - a;
  const Vec3d ac = corner(2) - a;
  const double farther = random.chance(0.1) ? 18.0 : 2.0;
  const double distance = std::min(extent * std::exp2(random.between(-6.0, farther)), 0x1p39);
  const std::size_t kind = random.below(6);
  Vec3d target = a;
  if (kind == 1 || kind == 2)
    target = a + ab * random.unit();
  if (kind == 3)
    target = a + (ab + ac) / 3.0;
  Vec3d origin = target + random.direction() * distance;
  if (kind == 4)  // in the plane, or nearly so
    origin = a + ab * random.between(-2.0, 2.0) + ac * random.between(-2.0, 2.0);
  if (kind == 5)  // along an edge
    origin = a - ab * random.between(0.1, 2.0);
  Ray<T> ray;
  ray.origin = static_cast<Vec3<T>>(origin);
  ray.direction = static_cast<Vec3<T>>(target) - ray.origin;
  if (kind >= 4)
    ray.direction = static_cast<Vec3<T>>(a + ab) - ray.origin;
  if (random.chance(0.7)) {
    const Axis axis = kAxes[random.below(3)];
    Vec3<T>& moved = random.chance(0.5) ? ray.direction : ray.origin;
    moved[axis] = detail::nudged(moved[axis], 12, random);
  }
  // An end of the interval where the target is, or nearly so.
  const double whole = random.chance(0.5) ? 1.0 : random.between(0.5, 1.5);
  const std::size_t interval = random.below(8);
  if (interval == 0)
    ray.tMax = detail::nudged(static_cast<T>(whole), 8, random);
  if (interval == 1)
    ray.tMin = detail::nudged(static_cast<T>(whole), 8, random);
  if (interval == 2)
    ray.tMin = -std::numeric_limits<T>::infinity();
  return random.chance(0.2) ? withAnyLength(ray, random) : ray;
}

/// Rays with a direction and finite numbers; those that miss by definition have tests elsewhere.
template <class T>
std::vector<Ray<T>> judgedRays(const TriangleMesh<T>& mesh, const Box3& bounds, std::size_t count,
                               std::uint64_t salt) {
  const auto half = static_cast<int>(count / 2);
  std::vector<Ray<T>> rays = hardRays(mesh, bounds, half, salt);
  Random random(salt + 1);
  const Vec3d size = static_cast<Vec3d>(bounds.size());
  const double extent = std::max({size.x, size.y, size.z, 0x1p-30});
  while (!bounds.isEmpty() && rays.size() < count) {
    const FaceIndices& face = mesh.faces[random.below(mesh.faces.size())];
    const bool isGood = std::all_of(face.begin(), face.end(), [&](std::uint32_t vertex) {
      return vertex < mesh.positions.size() && isFinite(mesh.positions[vertex]);
    });
    if (isGood)
      rays.push_back(nearMiss(mesh, face, extent, random));
  }
  std::erase_if(rays, [](const Ray<T>& ray) {
    return ray.direction == Vec3<T>{} || !isFinite(ray.direction) || !isFinite(ray.origin);
  });
  return rays;
}

}  // namespace planetree::test
