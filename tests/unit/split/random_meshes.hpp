#pragma once

#include <planetree/geometry/vec3.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>

/// Small meshes with integer coordinates, so that a judge can be exact, and their like with
/// coordinates of any kind.
namespace planetree::test {

/// Adds a face with corners of its own.
template <class T>
void addFace(TriangleMesh<T>& mesh, const std::array<Vec3<T>, 3>& corners) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  mesh.faces.push_back({first, first + 1, first + 2});
}

class MeshGenerator {
 public:
  explicit MeshGenerator(std::uint32_t seed) : random_(seed) {}

  [[nodiscard]] int between(int lower, int upper) {
    return std::uniform_int_distribution<int>(lower, upper)(random_);
  }

  /// Triangles with corners at most `reach` apart on the integer grid [0, extent]^3. Some are
  /// lines, some lie in planes across an axis.
  template <class T>
  [[nodiscard]] TriangleMesh<T> integerSoup(int faceCount, int extent, int reach) {
    return soup<T>(faceCount, [&] {
      const std::array<int, 3> centre = {between(0, extent), between(0, extent),
                                         between(0, extent)};
      const auto corner = [&] {
        const auto coordinate = [&](std::size_t axis) {
          return static_cast<T>(std::clamp(centre[axis] + between(-reach, reach), 0, extent));
        };
        return Vec3<T>{coordinate(0), coordinate(1), coordinate(2)};
      };
      return std::array{corner(), corner(), corner()};
    });
  }

  /// Long thin triangles across the integer grid [0, extent]^3: one edge is short.
  template <class T>
  [[nodiscard]] TriangleMesh<T> slivers(int faceCount, int extent) {
    return soup<T>(faceCount, [&] {
      const auto corner = [&] {
        return Vec3<T>{static_cast<T>(between(1, extent - 1)),
                       static_cast<T>(between(1, extent - 1)),
                       static_cast<T>(between(1, extent - 1))};
      };
      const Vec3<T> from = corner();
      const Vec3<T> to = corner();
      const Vec3<T> beside =
          to + Vec3<T>{static_cast<T>(between(-1, 1)), static_cast<T>(between(-1, 1)),
                       static_cast<T>(between(-1, 1))};
      return std::array{from, to, beside};
    });
  }

  /// Random faces in the planes across the axes through integers: squares cut in two, many of them
  /// edge to edge or on top of each other, with normals to either side.
  template <class T>
  [[nodiscard]] TriangleMesh<T> axisAlignedGrid(int squareCount, int extent) {
    TriangleMesh<T> mesh;
    for (int i = 0; i < squareCount; ++i) {
      const Axis across = kAxes[static_cast<std::size_t>(between(0, 2))];
      const Axis u = across == Axis::X ? Axis::Y : Axis::X;
      const Axis v = across == Axis::Z ? Axis::Y : Axis::Z;
      Vec3<T> corner;
      for (const Axis axis : kAxes)
        corner[axis] = static_cast<T>(between(0, extent - 1));
      Vec3<T> alongU;
      Vec3<T> alongV;
      alongU[u] = T(1);
      alongV[v] = T(1);
      if (between(0, 1) == 1)
        std::swap(alongU, alongV);
      const Vec3<T> opposite = corner + alongU + alongV;
      addFace<T>(mesh, {corner, corner + alongU, opposite});
      addFace<T>(mesh, {corner, opposite, corner + alongV});
    }
    return mesh;
  }

  /// Faces in one plane across an axis.
  template <class T>
  [[nodiscard]] TriangleMesh<T> coplanarSoup(int faceCount, int extent, Axis across, int height) {
    TriangleMesh<T> mesh = integerSoup<T>(faceCount, extent, extent / 3);
    for (Vec3<T>& position : mesh.positions)
      position[across] = static_cast<T>(height);
    return mesh;
  }

  /// Faces around one common corner, as a fan that fills all directions.
  template <class T>
  [[nodiscard]] TriangleMesh<T> fan(int faceCount, int extent) {
    const T middle = static_cast<T>(extent / 2);
    return soup<T>(faceCount, [&] {
      const auto corner = [&] {
        return Vec3<T>{static_cast<T>(between(0, extent)), static_cast<T>(between(0, extent)),
                       static_cast<T>(between(0, extent))};
      };
      return std::array{Vec3<T>{middle, middle, middle}, corner(), corner()};
    });
  }

  /// Triangles with coordinates of any kind in the unit cube, each at most `size` wide.
  template <class T>
  [[nodiscard]] TriangleMesh<T> soupOfAnyCoordinates(int faceCount, T size) {
    std::uniform_real_distribution<T> unit(T(0), T(1));
    return soup<T>(faceCount, [&] {
      const Vec3<T> corner = {unit(random_), unit(random_), unit(random_)};
      const auto other = [&] {
        return corner + Vec3<T>{unit(random_), unit(random_), unit(random_)} * size;
      };
      return std::array{corner, other(), other()};
    });
  }

 private:
  template <class T, class MakeCorners>
  TriangleMesh<T> soup(int faceCount, const MakeCorners& makeCorners) {
    TriangleMesh<T> mesh;
    for (int i = 0; i < faceCount; ++i)
      addFace<T>(mesh, makeCorners());
    return mesh;
  }

  std::mt19937 random_;
};

}  // namespace planetree::test
