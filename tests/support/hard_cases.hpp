#pragma once

#include <planetree/mesh/triangle_mesh.hpp>

#include "support/closed_meshes.hpp"
#include "support/random.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// The shared list of hard inputs: every stage is tested on it, and every bug that is found adds to
/// it.
namespace planetree::test {

template <class T>
struct HardMesh {
  std::string name;
  TriangleMesh<T> mesh;
};

namespace detail {

template <class T>
void addTriangle(TriangleMesh<T>& mesh, const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c});
  mesh.faces.push_back({first, first + 1, first + 2});
}

template <class T>
TriangleMesh<T> soup(std::uint64_t salt, int count, double size, const Vec3d& stretch = {1, 1, 1}) {
  Random random(salt);
  TriangleMesh<T> mesh;
  for (int i = 0; i < count; ++i) {
    const auto middle = random.pointIn<double>({-1, -1, -1}, {1, 1, 1});
    Vec3<T> corners[3];
    for (Vec3<T>& corner : corners) {
      const Vec3d offset = random.pointIn<double>({-size, -size, -size}, {size, size, size});
      corner = static_cast<Vec3<T>>(
          middle + Vec3d{offset.x * stretch.x, offset.y * stretch.y, offset.z * stretch.z});
    }
    addTriangle(mesh, corners[0], corners[1], corners[2]);
  }
  return mesh;
}

/// A flat grid spanned by two vectors.
template <class T>
TriangleMesh<T> grid(int n, const Vec3d& corner, const Vec3d& edgeU, const Vec3d& edgeV) {
  TriangleMesh<T> mesh;
  const auto at = [&](int i, int j) {
    return static_cast<Vec3<T>>(corner + edgeU * (static_cast<double>(i) / n) +
                                edgeV * (static_cast<double>(j) / n));
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      addTriangle(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1));
      addTriangle(mesh, at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return mesh;
}

template <class T>
void append(TriangleMesh<T>& mesh, const TriangleMesh<T>& more) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  for (const auto& [a, b, c] : more.faces)
    mesh.faces.push_back({a + first, b + first, c + first});
}

/// Triangles around one vertex at the origin, which the axes' planes all pass through.
template <class T>
TriangleMesh<T> fan(int count, double tilt) {
  TriangleMesh<T> mesh;
  const auto rim = [&](int i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    return static_cast<Vec3<T>>(Vec3d{std::cos(angle), std::sin(angle), tilt * std::cos(angle)});
  };
  for (int i = 0; i < count; ++i)
    addTriangle(mesh, Vec3<T>{}, rim(i), rim(i + 1));
  return mesh;
}

template <class T>
TriangleMesh<T> scaled(TriangleMesh<T> mesh, T scale, const Vec3<T>& offset = {}) {
  for (Vec3<T>& position : mesh.positions)
    position = position * scale + offset;
  return mesh;
}

}  // namespace detail

template <class T>
std::vector<HardMesh<T>> hardMeshes() {
  using detail::addTriangle;
  std::vector<HardMesh<T>> cases;
  const auto add = [&cases](std::string name, TriangleMesh<T> mesh) {
    cases.push_back({std::move(name), std::move(mesh)});
  };
  const Vec3<T> a{0, 0, 0};
  const Vec3<T> b{1, 0, 0};
  const Vec3<T> c{0, 1, 0};
  const T nan = std::numeric_limits<T>::quiet_NaN();
  const T infinity = std::numeric_limits<T>::infinity();

  add("empty", {});

  TriangleMesh<T> one;
  addTriangle(one, a, b, c);
  add("one face", one);

  TriangleMesh<T> duplicates;
  for (int i = 0; i < 100; ++i)
    detail::append(duplicates, one);
  add("a hundred copies of one face", duplicates);

  TriangleMesh<T> degenerate = detail::soup<T>(11, 20, 0.5);
  addTriangle(degenerate, a, b, b);
  addTriangle(degenerate, a, a, a);
  addTriangle(degenerate, Vec3<T>{-1, -1, -1}, a, Vec3<T>{1, 1, 1});
  addTriangle(degenerate, a, b, Vec3<T>{T(0.5), 0, 0});
  add("faces without area", degenerate);

  TriangleMesh<T> bad = detail::soup<T>(12, 20, 0.5);
  addTriangle(bad, a, b, Vec3<T>{nan, 0, 0});
  addTriangle(bad, a, Vec3<T>{0, infinity, 0}, c);
  bad.faces.push_back({0, 1, 1'000'000});
  bad.faces.push_back({0xFFFF'FFFFu, 1, 2});
  detail::append(bad, detail::soup<T>(13, 20, 0.5));
  add("bad faces among good ones", bad);

  add("random soup", detail::soup<T>(14, 300, 0.3));
  add("dense soup", detail::soup<T>(15, 100, 1.0));
  add("slivers", detail::soup<T>(16, 200, 1.0, {1, 1e-4, 1e-7}));
  add("grid in the plane z = 0", detail::grid<T>(10, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
  add("grid in the plane x = 0.1", detail::grid<T>(10, {0.1, -1, -1}, {0, 2, 0}, {0, 0, 2}));
  add("tilted grid", detail::grid<T>(10, {-1, -1, -0.3}, {2, 0, 0.3}, {0, 2, 0.7}));

  TriangleMesh<T> stack;
  for (int i = 0; i < 8; ++i) {
    detail::append(stack, detail::grid<T>(3, {-1, -1, 0.25 * i}, {2, 0, 0}, {0, 2, 0}));
    detail::append(stack, detail::grid<T>(3, {0.25 * i, -1, -1}, {0, 2, 0}, {0, 0, 2}));
  }
  add("grids that cross at split planes", stack);

  add("fan around the origin", detail::fan<T>(64, 0.0));
  add("tilted fan around the origin", detail::fan<T>(64, 0.7));

  TriangleMesh<T> junction;
  addTriangle(junction, Vec3<T>{-1, 0, 0}, Vec3<T>{1, 0, T(0.3)}, Vec3<T>{0, 1, T(0.1)});
  addTriangle(junction, Vec3<T>{-1, 0, 0}, Vec3<T>{0, -1, 0}, Vec3<T>{0, 0, T(0.15)});
  addTriangle(junction, Vec3<T>{0, 0, T(0.15)}, Vec3<T>{0, -1, 0}, Vec3<T>{1, 0, T(0.3)});
  addTriangle(junction, Vec3<T>{-1, 0, 0}, Vec3<T>{0, 0, T(0.15)}, Vec3<T>{1, 0, T(0.3)});
  add("T-junction closed by a face without area", junction);

  TriangleMesh<T> stadium = detail::scaled(detail::soup<T>(17, 60, 0.3), T(1e-3));
  detail::append(stadium, detail::grid<T>(4, {-1000, -1000, -1}, {2000, 0, 0}, {0, 2000, 3}));
  add("teapot in a stadium", stadium);

  TriangleMesh<T> diagonals;
  for (int i = 0; i < 40; ++i) {
    const T x = static_cast<T>(i) / T(40);
    addTriangle(diagonals, Vec3<T>{x, 0, 0}, Vec3<T>{1, x, 1}, Vec3<T>{1, x, T(1.001)});
  }
  add("long diagonal needles", diagonals);

  for (ClosedMesh<T>& closed : closedMeshes<T>()) {
    if (closed.mesh.faces.size() < 2100)
      add("closed: " + closed.name, std::move(closed.mesh));
  }
  add("soup far from the origin",
      detail::scaled(detail::soup<T>(18, 200, 0.3), T(1), Vec3<T>{T(1e5), T(-2e5), T(3e5)}));
  add("soup at the smallest scale", detail::scaled(detail::soup<T>(19, 200, 0.3), T(0x1p-30)));
  add("soup at the largest scale", detail::scaled(detail::soup<T>(20, 200, 0.3), T(0x1p30)));

  TriangleMesh<T> denormal = detail::soup<T>(21, 50, 0.3);
  for (Vec3<T>& position : denormal.positions) {
    if (position.x < T(0))
      position.x = std::numeric_limits<T>::denorm_min() * T(3);
    if (position.y < T(0))
      position.y = T(-0.0);
  }
  add("denormal and negative zero coordinates", denormal);
  return cases;
}

/// Rays that are hard for a mesh: random, aimed at corners and along edges, along the axes, inside
/// faces' planes, with signed zeros, with intervals of every kind, and such as miss by definition.
template <class T>
std::vector<Ray<T>> hardRays(const TriangleMesh<T>& mesh, const Box3& bounds, int count,
                             std::uint64_t salt) {
  Random random(salt);
  const Box3 box = bounds.isEmpty() ? Box3{{-1, -1, -1}, {1, 1, 1}} : bounds;
  const Vec3d lower = static_cast<Vec3d>(box.lower);
  const Vec3d size = static_cast<Vec3d>(box.upper) - lower;
  const double margin = 0.3 * std::max({size.x, size.y, size.z, 1e-30});
  const Vec3d outward{margin, margin, margin};
  const auto anyPoint = [&] { return random.pointIn<T>(lower - outward, lower + size + outward); };
  const auto anyFace = [&]() -> const FaceIndices* {
    if (mesh.faces.empty())
      return nullptr;
    const FaceIndices& face = mesh.faces[random.below(mesh.faces.size())];
    for (const std::uint32_t vertex : face) {
      if (vertex >= mesh.positions.size() || !isFinite(mesh.positions[vertex]))
        return nullptr;
    }
    return &face;
  };
  const auto axisDirection = [&] {
    const T zero = random.chance(0.5) ? T(0) : T(-0.0);
    Vec3<T> direction{zero, random.chance(0.5) ? T(0) : T(-0.0), zero};
    direction[kAxes[random.below(3)]] = random.chance(0.5) ? T(1) : T(-1);
    return direction;
  };

  std::vector<Ray<T>> rays;
  while (static_cast<int>(rays.size()) < count) {
    Ray<T> ray{anyPoint(), static_cast<Vec3<T>>(random.direction())};
    const FaceIndices* face = anyFace();
    const std::size_t kind = face ? random.below(10) : random.below(3);
    if (kind == 1)
      ray.direction = axisDirection();
    if (kind == 2)
      ray.direction = ray.direction * static_cast<T>(std::exp2(random.between(-20, 20)));
    if (kind >= 3) {
      const Vec3<T> a = mesh.positions[(*face)[0]];
      const Vec3<T> b = mesh.positions[(*face)[1]];
      const Vec3<T> c = mesh.positions[(*face)[2]];
      if (kind == 3)
        ray.direction = a - ray.origin;
      if (kind == 4)
        ray.direction = a + (b - a) * static_cast<T>(random.unit()) - ray.origin;
      if (kind == 5)
        ray.direction = (a + b + c) / T(3) - ray.origin;
      if (kind == 6) {  // along an edge
        ray.origin = a - (b - a);
        ray.direction = b - a;
      }
      if (kind == 7) {  // through a vertex, along an axis
        ray.direction = axisDirection();
        ray.origin = a - ray.direction * static_cast<T>(margin);
      }
      if (kind == 8) {  // starting on a vertex
        ray.origin = a;
        if (random.chance(0.5))
          ray.direction = axisDirection();
      }
      if (kind == 9) {  // in the plane of the face
        ray.origin = a + (b - a) * T(2) + (c - a) * T(2);
        ray.direction = (a + b) / T(2) - ray.origin;
      }
    }
    const std::size_t interval = random.below(8);
    const auto reach =
        static_cast<T>(margin * 4 / std::max(1e-30, static_cast<double>(length(ray.direction))));
    if (interval == 1)
      ray.tMax = reach * static_cast<T>(random.unit());
    if (interval == 2)
      ray.tMin = reach * static_cast<T>(random.between(-0.5, 0.5));
    if (interval == 3)
      ray.tMin = -std::numeric_limits<T>::infinity();
    if (interval == 4)
      ray.tMin = ray.tMax = reach * static_cast<T>(random.unit());
    if (interval == 5)
      ray.tMax = T(-0.0);
    rays.push_back(ray);
  }
  return rays;
}

/// Rays that hit nothing by definition, whatever is in their way.
template <class T>
std::vector<Ray<T>> invalidRays() {
  const T nan = std::numeric_limits<T>::quiet_NaN();
  const T infinity = std::numeric_limits<T>::infinity();
  std::vector<Ray<T>> rays = {
      {{0, 0, 5}, {0, 0, 0}},          {{0, 0, 5}, {T(-0.0), 0, T(-0.0)}},
      {{0, 0, 5}, {nan, 0, -1}},       {{0, 0, 5}, {0, 0, nan}},
      {{0, 0, 5}, {0, 0, -infinity}},  {{0, 0, 5}, {infinity, 0, -1}},
      {{nan, 0, 5}, {0, 0, -1}},       {{0, infinity, 5}, {0, 0, -1}},
      {{0, 0, infinity}, {0, 0, -1}},  {{nan, nan, nan}, {nan, nan, nan}},
      {{0, 0, 5}, {0, 0, -1}, 2, 1},   {{0, 0, 5}, {0, 0, -1}, nan, 10},
      {{0, 0, 5}, {0, 0, -1}, 0, nan}, {{0, 0, 5}, {0, 0, -1}, infinity, infinity},
  };
  return rays;
}

}  // namespace planetree::test
