#include "soak/closed_solids.hpp"

#include "soak/convex_hull.hpp"
#include "support/closed_meshes.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace planetree::test {
namespace {

Solid starShaped(std::string name, TriangleMesh<double> mesh) {
  Solid solid;
  solid.name = std::move(name);
  solid.cores = {Vec3d{}};
  solid.coreOfFace.assign(mesh.faces.size(), 0);
  // All of the ball lies behind every face.
  solid.clearance = std::numeric_limits<double>::infinity();
  for (const auto& [i, j, k] : mesh.faces) {
    const Vec3d a = mesh.positions[i];
    const Vec3d normal = normalized(cross(mesh.positions[j] - a, mesh.positions[k] - a));
    solid.clearance = std::min(solid.clearance, dot(normal, a));
  }
  solid.mesh = std::move(mesh);
  return solid;
}

TriangleMesh<double> sphere(TriangleMesh<double> mesh, int levels) {
  for (int level = 0; level < levels; ++level)
    mesh = subdivide(mesh, [](const Vec3d& p) { return normalized(p); });
  return mesh;
}

TriangleMesh<double> withRandomRadii(TriangleMesh<double> mesh, double least, double most,
                                     std::uint64_t salt) {
  Random random(salt);
  for (Vec3d& position : mesh.positions)
    position = position * random.between(least, most);
  return mesh;
}

TriangleMesh<double> stretched(TriangleMesh<double> mesh, const Vec3d& factors) {
  for (Vec3d& position : mesh.positions)
    position = {position.x * factors.x, position.y * factors.y, position.z * factors.z};
  return mesh;
}

/// A box with lines so near to its edges that most faces are slivers.
TriangleMesh<double> sliverBox() {
  const std::array<double, 5> steps = {0.0, 0x1p-20, 0x1p-14, 0x1p-7, 0.4};
  const int last = 2 * static_cast<int>(steps.size()) - 1;
  TriangleMesh<double> mesh = gridCube(last);
  for (Vec3d& position : mesh.positions) {
    for (const Axis axis : kAxes) {
      const auto line = static_cast<int>(std::lround((position[axis] + 1.0) * last / 2.0));
      position[axis] = 2 * line < last ? -1.0 + steps[static_cast<std::size_t>(line)]
                                       : 1.0 - steps[static_cast<std::size_t>(last - line)];
    }
  }
  return mesh;
}

/// A cylinder whose ends are fans around a point of their rim.
TriangleMesh<double> drum(std::uint32_t corners) {
  TriangleMesh<double> mesh;
  for (const double z : {-0.5, 0.5}) {
    for (std::uint32_t i = 0; i < corners; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / corners;
      mesh.positions.push_back({std::cos(angle), std::sin(angle), z});
    }
  }
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t next = (i + 1) % corners;
    mesh.faces.insert(mesh.faces.end(),
                      {{i, next, corners + next}, {i, corners + next, corners + i}});
    if (i != 0 && next != 0) {
      mesh.faces.insert(mesh.faces.end(), {{0, next, i}, {corners, corners + i, corners + next}});
    }
  }
  return mesh;
}

/// Around the z axis, the middle of the tube one away from it.
Solid torus(std::string name, double tubeRadius, std::uint32_t around, std::uint32_t across) {
  Solid solid;
  solid.name = std::move(name);
  const auto middle = [&](std::uint32_t i) {
    const double angle = 2.0 * std::numbers::pi * i / around;
    return Vec3d{std::cos(angle), std::sin(angle), 0.0};
  };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / across;
      const Vec3d outward = middle(i) * (tubeRadius * std::cos(angle));
      solid.mesh.positions.push_back(middle(i) + outward +
                                     Vec3d{0.0, 0.0, tubeRadius * std::sin(angle)});
    }
  }
  for (std::uint32_t i = 0; i < around; ++i) {
    solid.cores.push_back((middle(i) + middle(i + 1)) * 0.5);
    const std::uint32_t here = i * across;
    const std::uint32_t there = (i + 1) % around * across;
    for (std::uint32_t j = 0; j < across; ++j) {
      const std::uint32_t next = (j + 1) % across;
      solid.mesh.faces.insert(solid.mesh.faces.end(), {{here + j, there + j, there + next},
                                                       {here + j, there + next, here + next}});
      solid.coreOfFace.insert(solid.coreOfFace.end(), {i, i});
    }
  }
  solid.clearance = tubeRadius * 0.4;
  return solid;
}

std::vector<Vec3d> randomPoints(int count, std::uint64_t salt) {
  Random random(salt);
  std::vector<Vec3d> points;
  while (static_cast<int>(points.size()) < count)
    points.push_back(random.direction() * std::cbrt(random.unit()));
  return points;
}

std::vector<Vec3d> randomPointsOnAnEllipsoid(int count, std::uint64_t salt) {
  Random random(salt);
  std::vector<Vec3d> points;
  while (static_cast<int>(points.size()) < count) {
    const Vec3d direction = random.direction();
    points.push_back({direction.x, direction.y * 0.5, direction.z * 0.25});
  }
  return points;
}

struct Placement {
  std::string name;
  double scale;
  Vec3d offset;
};

/// The distance between neighbouring numbers of type T up to this size.
template <class T>
double ulpAt(double size) {
  return std::exp2(std::floor(std::log2(std::max(size, 1e-30)))) *
         static_cast<double>(std::numeric_limits<T>::epsilon());
}

struct Size {
  double extent = 0.0;  ///< the largest side of the box
  double reach = 0.0;   ///< the largest coordinate
};

Size sizeOf(const TriangleMesh<double>& mesh) {
  Vec3d lower = mesh.positions.front();
  Vec3d upper = lower;
  for (const Vec3d& position : mesh.positions) {
    for (const Axis axis : kAxes) {
      lower[axis] = std::min(lower[axis], position[axis]);
      upper[axis] = std::max(upper[axis], position[axis]);
    }
  }
  Size size;
  for (const Axis axis : kAxes) {
    size.extent = std::max(size.extent, upper[axis] - lower[axis]);
    size.reach = std::max({size.reach, -lower[axis], upper[axis]});
  }
  return size;
}

double largestOf(const Vec3d& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

constexpr double kSmallestExtent = 0x1p-30;
constexpr double kLargestExtent = 0x1p30;
constexpr double kLargestCoordinate = 0x1p30;

/// How far inside a point must be: corners and the point are rounded, and the test of a triangle
/// may be off by its bound, of the distance to the tree's bounds, which are floats.
template <class T>
double neededDistance(const Size& size, const Placement& placement) {
  const double reach = largestOf(placement.offset) + size.reach * placement.scale;
  const double distance = size.extent * placement.scale + 2.0 * ulpAt<float>(reach);
  return 4.0 * ulpAt<T>(reach) +
         32.0 * static_cast<double>(std::numeric_limits<T>::epsilon()) * distance;
}

template <class T>
bool isPossible(const Solid& solid, const Size& size, const Placement& placement) {
  const double extent = size.extent * placement.scale;
  return extent >= kSmallestExtent && extent <= kLargestExtent &&
         largestOf(placement.offset) + size.reach * placement.scale <= kLargestCoordinate &&
         neededDistance<T>(size, placement) <= 0.5 * solid.clearance * placement.scale;
}

/// The smallest power of two at which the solid is more than a few ulps wide so far away.
template <class T>
Placement coarse(const Solid& solid, const Size& size) {
  Placement placement{"coarse", kSmallestExtent, {0x1.8p29, -0x1.9p29, 0x1.7p29}};
  while (placement.scale < kLargestExtent && !isPossible<T>(solid, size, placement))
    placement.scale *= 2.0;
  return placement;
}

template <class T>
std::vector<Placement> placements(const Solid& solid, const Size& size) {
  const double least = std::exp2(std::ceil(std::log2(kSmallestExtent / size.extent)));
  const double most = std::exp2(std::floor(std::log2(kLargestExtent / size.extent)));
  return {{"unit", 1.0, {}},
          {"third", 1.0 / 3.0, {0.1, 0.2, -0.3}},
          {"tiny", least, {}},
          {"huge", most, {}},
          {"far", 1.0, {1e4, -3e4, 2e4}},
          {"small, far", 0x1p-12, {3.0, -5.0, 7.0}},
          coarse<T>(solid, size)};
}

template <class T>
PlacedSolid<T> place(const Solid& solid, const Size& size, const Placement& placement) {
  const auto moved = [&](const Vec3d& p) { return p * placement.scale + placement.offset; };
  PlacedSolid<T> placed;
  placed.name = solid.name;
  placed.placement = placement.name;
  placed.isNearUnitScale = placement.name == "unit" || placement.name == "third";
  placed.mesh.faces = solid.mesh.faces;
  for (const Vec3d& position : solid.mesh.positions)
    placed.mesh.positions.push_back(static_cast<Vec3<T>>(moved(position)));
  for (const Vec3d& core : solid.cores)
    placed.cores.push_back(moved(core));
  placed.coreOfFace = solid.coreOfFace;
  placed.clearance = solid.clearance * placement.scale;
  placed.center = placement.offset;
  placed.extent = size.extent * placement.scale;
  placed.stepInside = std::max(0x1p-8, neededDistance<T>(size, placement) / placed.clearance);
  return placed;
}

}  // namespace

std::vector<Solid> closedSolids() {
  std::vector<Solid> solids;
  const auto add = [&](std::string name, TriangleMesh<double> mesh) {
    solids.push_back(starShaped(std::move(name), std::move(mesh)));
  };
  add("icosphere", sphere(icosahedron(), 2));
  add("fine icosphere", sphere(icosahedron(), 4));
  add("octasphere", sphere(octahedron(), 3));
  add("grid cube", gridCube(8));
  add("long box", stretched(gridCube(6), {64.0, 1.0, 0x1p-6}));
  add("sliver box", sliverBox());
  add("drum", drum(96));
  add("star", withRandomRadii(sphere(icosahedron(), 3), 0.5, 1.5, 501));
  add("spiky star", withRandomRadii(sphere(icosahedron(), 2), 0.1, 1.5, 502));
  add("hull in a ball", convexHull(randomPoints(400, 503)));
  add("hull on an ellipsoid", convexHull(randomPointsOnAnEllipsoid(300, 504)));
  solids.push_back(torus("torus", 0.4, 32, 16));
  solids.push_back(torus("thin torus", 0x1p-6, 48, 6));
  return solids;
}

template <class T>
std::vector<PlacedSolid<T>> placedSolids() {
  std::vector<PlacedSolid<T>> result;
  for (const Solid& solid : closedSolids()) {
    const Size size = sizeOf(solid.mesh);
    for (const Placement& placement : placements<T>(solid, size)) {
      if (isPossible<T>(solid, size, placement))
        result.push_back(place<T>(solid, size, placement));
    }
  }
  return result;
}

template std::vector<PlacedSolid<float>> placedSolids();
template std::vector<PlacedSolid<double>> placedSolids();

}  // namespace planetree::test
