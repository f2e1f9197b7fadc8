#pragma once

#include <planetree/geometry/vec3.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <string>
#include <vector>

/// Closed meshes made in code, over the whole range of docs/limits.md, and points that are surely
/// inside of them.
namespace planetree::test {

/// A solid with corners in double, of about the size of one. Each face is seen, as a whole, from
/// every point of a ball around one of the cores, and so is all that lies between.
struct Solid {
  std::string name;
  TriangleMesh<double> mesh;
  std::vector<Vec3d> cores;
  std::vector<std::uint32_t> coreOfFace;
  double clearance = 0.0;  ///< the radius of the balls
};

/// Subdivided spheres, boxes with square, long and sliver faces, tori, a drum whose ends are fans
/// of slivers, random star-shaped solids, and convex hulls of random points.
[[nodiscard]] std::vector<Solid> closedSolids();

/// A solid scaled and moved, and rounded to T. The rounded mesh is the truth: it is as closed as
/// the other, even where corners or faces become one. Rounding moves no point of the surface by
/// more than an ulp; inner points keep a distance from it which that, the rounding of the point
/// itself, and the documented bound of the triangle test fit into.
template <class T>
struct PlacedSolid {
  std::string name;
  std::string placement;
  bool isNearUnitScale = false;  ///< neither tiny, nor huge, nor far away
  TriangleMesh<T> mesh;
  std::vector<Vec3d> cores;
  std::vector<std::uint32_t> coreOfFace;
  double clearance = 0.0;
  Vec3d center;
  double extent = 0.0;
  /// The part of the way from a point of the surface to the core of its face after which one is
  /// inside by enough; at most 1/2.
  double stepInside = 0.0;
};

/// All solids in all places, but for those where too little of the inside would be left.
template <class T>
[[nodiscard]] std::vector<PlacedSolid<T>> placedSolids();

extern template std::vector<PlacedSolid<float>> placedSolids();
extern template std::vector<PlacedSolid<double>> placedSolids();

}  // namespace planetree::test
