#include "bench/scene/generated_scenes.hpp"
#include "bench/scene/surface_grid.hpp"
#include "bench/support/random.hpp"

#include "render/camera.hpp"

#include <cmath>
#include <cstdint>

namespace planetree::bench {

namespace {

constexpr std::uint64_t kSeed = 20'260'201u;
constexpr int kTreesAlongSide = 3;
constexpr double kTreeDistance = 6.0;
constexpr int kLevels = 5;  ///< of branches; those of the last one are twigs with leaves
constexpr std::uint32_t kSidesOfBranch = 5;
constexpr int kLeavesOfTwig = 14;

struct Branch {
  Vec3d start;
  Vec3d direction;
  double length;
  double radius;

  [[nodiscard]] Vec3d at(double part) const { return start + direction * (length * part); }
};

/// A direction that leaves `along` by this angle, to any side.
Vec3d turnedAside(const Vec3d& along, double angle, Random& random) {
  const render::CameraAxes frame = render::cameraAxes(along, Vec3d{0.0, 1.0, 0.0});
  const Vec3d circle = onCircle(std::sin(angle), random.unit(), 0.0);
  return normalized(along * std::cos(angle) + frame.right * circle.x + frame.up * circle.z);
}

void addBranch(TriangleMesh<float>& mesh, const Branch& branch) {
  const render::CameraAxes frame = render::cameraAxes(branch.direction, Vec3d{0.0, 1.0, 0.0});
  addSurface(mesh, kSidesOfBranch, 1, [&](double turn, double along) {
    const Vec3d circle = onCircle(branch.radius * (1.0 - 0.4 * along), turn, 0.0);
    return branch.at(along) + frame.right * circle.x + frame.up * circle.z;
  });
}

void addLeaf(TriangleMesh<float>& mesh, const Vec3d& stalk, const Vec3d& along, Random& random) {
  const double size = random.between(0.05, 0.11);
  const Vec3d across = normalized(cross(along, random.direction())) * (size * 0.3);
  // A kite: the corners of the square become stalk, side, side and tip.
  addSurface(mesh, 1, 1, [&](double u, double v) {
    return stalk + along * (0.5 * size * (u + v)) + across * (u - v);
  });
}

void grow(TriangleMesh<float>& mesh, const Branch& branch, int level, Random& random) {
  addBranch(mesh, branch);
  if (level == kLevels) {
    for (int leaf = 0; leaf < kLeavesOfTwig; ++leaf) {
      const Vec3d stalk = branch.at(random.unit());
      addLeaf(mesh, stalk, turnedAside(branch.direction, random.between(0.4, 1.3), random), random);
    }
    return;
  }
  const int forks = level == 0 ? 7 : 4;
  for (int fork = 0; fork < forks; ++fork) {
    const Vec3d start = branch.at(random.between(0.45, 1.0));
    const Vec3d aside = turnedAside(branch.direction, random.between(0.3, 0.9), random);
    const Vec3d upward = normalized(aside + Vec3d{0.0, 0.12, 0.0});
    grow(mesh, {start, upward, branch.length * random.between(0.5, 0.75), branch.radius * 0.5},
         level + 1, random);
  }
}

}  // namespace

TriangleMesh<float> makeFoliage() {
  Random random(kSeed);
  TriangleMesh<float> mesh;
  const double size = kTreeDistance * kTreesAlongSide;
  addSurface(mesh, 24, 24, [&](double u, double v) {
    return Vec3d{u * size, 0.15 * std::sin(9.0 * u) * std::cos(7.0 * v), (1.0 - v) * size};
  });
  for (int row = 0; row < kTreesAlongSide; ++row) {
    for (int column = 0; column < kTreesAlongSide; ++column) {
      const double x = kTreeDistance * (column + random.between(0.25, 0.75));
      const double z = kTreeDistance * (row + random.between(0.25, 0.75));
      const Vec3d trunk = normalized(Vec3d{random.between(-0.1, 0.1), 1.0, 0.0});
      grow(mesh, {{x, 0.0, z}, trunk, random.between(2.2, 3.0), 0.16}, 0, random);
    }
  }
  return mesh;
}

}  // namespace planetree::bench
