#include "bench/scene/generated_scenes.hpp"
#include "bench/scene/surface_grid.hpp"
#include "bench/support/random.hpp"

#include <cmath>
#include <numbers>

namespace planetree::bench {

namespace {

constexpr std::uint64_t kSeed = 20'260'202u;

// The hall is centred on the y axis and stands on y = 0.
constexpr double kHalfLength = 12.0;
constexpr double kHalfWidth = 6.0;
constexpr double kWallHeight = 6.0;

/// A parallelogram of two triangles: how walls are modelled, however large.
void addPanel(TriangleMesh<float>& mesh, const Vec3d& corner, const Vec3d& a, const Vec3d& b) {
  addSurface(mesh, 1, 1, [&](double u, double v) { return corner + a * u + b * v; });
}

void addBox(TriangleMesh<float>& mesh, const Vec3d& lower, const Vec3d& size) {
  const Vec3d x = {size.x, 0.0, 0.0};
  const Vec3d y = {0.0, size.y, 0.0};
  const Vec3d z = {0.0, 0.0, size.z};
  addPanel(mesh, lower, x, y);
  addPanel(mesh, lower, z, x);
  addPanel(mesh, lower, y, z);
  addPanel(mesh, lower + size, -y, -x);
  addPanel(mesh, lower + size, -x, -z);
  addPanel(mesh, lower + size, -z, -y);
}

/// A surface of revolution; `profile(v)` is the radius and the height at v from 0 to 1.
template <class Profile>
void addTurned(TriangleMesh<float>& mesh, const Vec3d& foot, std::uint32_t sides,
               std::uint32_t rings, const Profile& profile) {
  addSurface(mesh, sides, rings, [&](double turn, double v) {
    const auto [radius, height] = profile(v);
    return foot + onCircle(radius, turn, height);
  });
}

/// A point of the barrel vault over the walls; `rise` is 0 at its springing line, and 1 in its
/// arch.
Vec3d vaultPoint(double x, double along, double rise) {
  const Vec3d arch = onCircle(kHalfWidth, 0.5 * along, 0.0);
  return {x, kWallHeight + rise * 0.6 * arch.z, arch.x};
}

void addShell(TriangleMesh<float>& mesh) {
  const Vec3d floor = {-kHalfLength, 0.0, -kHalfWidth};
  const Vec3d along = {2.0 * kHalfLength, 0.0, 0.0};
  const Vec3d across = {0.0, 0.0, 2.0 * kHalfWidth};
  const Vec3d up = {0.0, kWallHeight, 0.0};
  addPanel(mesh, floor, across, along);
  addPanel(mesh, floor, along, up);
  addPanel(mesh, floor + across, up, along);
  addPanel(mesh, floor, up, across);
  addPanel(mesh, floor + along, across, up);
  addSurface(mesh, 48, 64,
             [](double u, double v) { return vaultPoint((2.0 * v - 1.0) * kHalfLength, u, 1.0); });
  for (const double x : {-kHalfLength, kHalfLength})
    addSurface(mesh, 48, 1, [x](double u, double v) { return vaultPoint(x, u, v); });
}

/// A fluted column with a bulging foot and capital.
void addColumn(TriangleMesh<float>& mesh, const Vec3d& foot) {
  addSurface(mesh, 96, 40, [&](double turn, double v) {
    const double flutes = 0.02 * std::cos(2.0 * std::numbers::pi * 16.0 * turn);
    const double ends = 0.16 * std::pow(2.0 * v - 1.0, 16.0);
    return foot + onCircle(0.32 + flutes + ends, turn, v * kWallHeight);
  });
}

void addTable(TriangleMesh<float>& mesh, const Vec3d& place) {
  addBox(mesh, place + Vec3d{-0.9, 0.72, -0.5}, {1.8, 0.05, 1.0});
  for (const double x : {-0.85, 0.79}) {
    for (const double z : {-0.45, 0.39})
      addBox(mesh, place + Vec3d{x, 0.0, z}, {0.06, 0.72, 0.06});
  }
}

void addChair(TriangleMesh<float>& mesh, const Vec3d& place, double side) {
  addBox(mesh, place + Vec3d{-0.22, 0.42, -0.22}, {0.44, 0.04, 0.44});
  addBox(mesh, place + Vec3d{-0.22, 0.46, 0.2 * side - 0.02}, {0.44, 0.5, 0.04});
  for (const double x : {-0.21, 0.17}) {
    for (const double z : {-0.21, 0.17})
      addBox(mesh, place + Vec3d{x, 0.0, z}, {0.04, 0.42, 0.04});
  }
}

/// A turned vase: small, and finer than anything else in the hall.
void addVase(TriangleMesh<float>& mesh, const Vec3d& foot, double size, double waist) {
  addTurned(mesh, foot, 72, 90, [=](double v) {
    const double radius = 0.3 + 0.25 * std::sin(std::numbers::pi * (1.6 * v + waist));
    return std::pair(size * radius, size * 1.4 * v);
  });
}

/// A ring of candles under the vault.
void addChandelier(TriangleMesh<float>& mesh, const Vec3d& centre) {
  addSurface(mesh, 120, 16, [&](double turn, double v) {
    const Vec3d ring = onCircle(0.04, v, 0.0);
    return centre + onCircle(0.9 + ring.x, turn, ring.z);
  });
  for (int candle = 0; candle < 12; ++candle) {
    const Vec3d foot = centre + onCircle(0.9, candle / 12.0, 0.04);
    addTurned(mesh, foot, 24, 12,
              [](double v) { return std::pair(0.03 * std::sqrt(1.0 - v * v * v * v), 0.25 * v); });
  }
}

/// A curtain in folds in front of a wall.
void addCurtain(TriangleMesh<float>& mesh, double x, double z) {
  addSurface(mesh, 160, 60, [=](double u, double v) {
    const double fold = 0.08 * std::sin(2.0 * std::numbers::pi * 9.0 * u + 2.0 * v) * (1.2 - v);
    return Vec3d{x + 2.0 * (u - 0.5), 0.3 + 4.2 * v, z + fold};
  });
}

}  // namespace

TriangleMesh<float> makeInterior() {
  Random random(kSeed);
  TriangleMesh<float> mesh;
  addShell(mesh);
  for (int i = 0; i < 7; ++i) {
    const double x = -9.9 + 3.3 * i;
    for (const double side : {-1.0, 1.0}) {
      addColumn(mesh, {x, 0.0, 4.2 * side});
      addCurtain(mesh, x + 1.65, 5.8 * side);
    }
  }
  for (int row = 0; row < 6; ++row) {
    for (const double z : {-2.0, 2.0}) {
      const Vec3d place = {-7.5 + 3.0 * row + random.between(-0.2, 0.2), 0.0, z};
      addTable(mesh, place);
      addVase(mesh, place + Vec3d{random.between(-0.6, 0.6), 0.77, random.between(-0.3, 0.3)},
              random.between(0.2, 0.4), random.between(0.0, 0.6));
      for (const double x : {-0.5, 0.5}) {
        for (const double side : {-1.0, 1.0})
          addChair(mesh, place + Vec3d{x + random.between(-0.1, 0.1), 0.0, 0.75 * side}, side);
      }
    }
  }
  for (const double x : {-6.0, 0.0, 6.0})
    addChandelier(mesh, {x, 4.4, 0.0});
  return mesh;
}

}  // namespace planetree::bench
