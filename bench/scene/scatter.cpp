#include "bench/scene/sized_scenes.hpp"
#include "bench/scene/surface_grid.hpp"
#include "bench/support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace planetree::bench {

namespace {

constexpr std::uint64_t kSeed = 20'260'203u;
constexpr double kSize = 100.0;  ///< of the cube

/// A ring of radius 1, as thick as half of that.
TriangleMesh<float> makeRing() {
  TriangleMesh<float> mesh;
  addSurface(mesh, 14, 7, [](double u, double v) {
    const double angle = 2.0 * std::numbers::pi * v;
    return onCircle(0.75 + 0.25 * std::cos(angle), u, 0.25 * std::sin(angle));
  });
  return mesh;
}

/// A ball of radius 1: the faces of a cube, blown up. It has no poles, where triangles would be
/// empty.
TriangleMesh<float> makeBall() {
  TriangleMesh<float> mesh;
  for (const double side : {-1.0, 1.0}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      addSurface(mesh, 4, 4, [&](double u, double v) {
        std::array<double, 3> point = {};
        point[axis] = side;
        point[(axis + 1) % 3] = 2.0 * u - 1.0;
        point[(axis + 2) % 3] = side * (2.0 * v - 1.0);
        return normalized(Vec3d{point[0], point[1], point[2]});
      });
    }
  }
  return mesh;
}

/// Where small meshes gather.
struct Cluster {
  Vec3d center;
  double radius = 0.0;
  double meshSize = 0.0;  ///< the largest radius of its meshes
};

/// Small numbers are as likely as large ones, each to its own scale.
double logUniform(Random& random, double least, double most) {
  return least * std::pow(most / least, random.unit());
}

Cluster makeCluster(Random& random, double meshCount) {
  Cluster cluster;
  cluster.radius = logUniform(random, 0.03, 0.3) * kSize;
  for (const Axis axis : kAxes)
    cluster.center[axis] = random.between(cluster.radius, kSize - cluster.radius);
  // Meshes overlap about as much in each cluster of each scene.
  cluster.meshSize = 0.5 * cluster.radius / std::cbrt(meshCount);
  return cluster;
}

/// As many clusters as there are meshes along the side of a cube of them all: both numbers grow.
std::vector<Cluster> makeClusters(Random& random, double meshCount) {
  const double count = std::ceil(std::cbrt(meshCount));
  std::vector<Cluster> clusters;
  for (double i = 0.0; i < count; ++i)
    clusters.push_back(makeCluster(random, meshCount / count));
  return clusters;
}

/// A place in a cluster; the nearer to its center, the denser.
Vec3d placeIn(const Cluster& cluster, Random& random) {
  const double distance = cluster.radius * std::sqrt(random.unit());
  return cluster.center + random.direction() * distance;
}

/// Adds a copy of a mesh, turned any way.
void addTurned(TriangleMesh<float>& mesh, const TriangleMesh<float>& part, const Vec3d& place,
               double size, Random& random) {
  const Vec3d up = random.direction();
  const Vec3d right = normalized(cross(up, random.direction()));
  const Vec3d front = cross(right, up);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec3f& position : part.positions) {
    const Vec3d at = Vec3d(position) * size;
    mesh.positions.push_back(Vec3f(place + right * at.x + up * at.y + front * at.z));
  }
  for (const auto& [a, b, c] : part.faces)
    mesh.faces.push_back({first + a, first + b, first + c});
}

}  // namespace

TriangleMesh<float> makeScatter(std::uint64_t triangles) {
  const std::array parts = {makeRing(), makeBall()};
  const double trianglesPerPart =
      static_cast<double>(parts[0].faces.size() + parts[1].faces.size()) / 2.0;
  const double partCount = std::ceil(static_cast<double>(triangles) / trianglesPerPart);
  Random random(kSeed);
  const std::vector<Cluster> clusters = makeClusters(random, partCount);
  TriangleMesh<float> mesh;
  mesh.faces.reserve(triangles + parts[1].faces.size());
  for (std::size_t i = 0; mesh.faces.size() < triangles; ++i) {
    const Cluster& cluster = clusters[i / parts.size() % clusters.size()];
    const Vec3d place = placeIn(cluster, random);
    const double size = logUniform(random, 0.2, 1.0) * cluster.meshSize;
    addTurned(mesh, parts[i % parts.size()], place, size, random);
  }
  return mesh;
}

}  // namespace planetree::bench
