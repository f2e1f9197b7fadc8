#include "bench/scene/generated_scenes.hpp"
#include "bench/scene/surface_grid.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace planetree::bench {

namespace {

constexpr double kSize = 100.0;
constexpr double kHeight = 18.0;
constexpr double kFirstFrequency = 4.0;

/// A number in [0, 1) for a point of the grid: Steele, Lea, Flood, "Fast splittable pseudorandom
/// number generators", OOPSLA 2014 (the finalizer of SplitMix64).
double latticeValue(std::int64_t x, std::int64_t z) {
  std::uint64_t bits = static_cast<std::uint64_t>(x) * 0x9E37'79B9'7F4A'7C15u +
                       static_cast<std::uint64_t>(z) * 0xC2B2'AE3D'27D4'EB4Fu;
  bits = (bits ^ (bits >> 30)) * 0xBF58'476D'1CE4'E5B9u;
  bits = (bits ^ (bits >> 27)) * 0x94D0'49BB'1331'11EBu;
  bits ^= bits >> 31;
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

double smooth(double t) {
  return t * t * (3.0 - 2.0 * t);
}

/// Values of the grid, blended smoothly between its points.
double valueNoise(double x, double z) {
  const double left = std::floor(x);
  const double back = std::floor(z);
  const auto i = static_cast<std::int64_t>(left);
  const auto k = static_cast<std::int64_t>(back);
  const double u = smooth(x - left);
  const double v = smooth(z - back);
  const double near = latticeValue(i, k) * (1.0 - u) + latticeValue(i + 1, k) * u;
  const double far = latticeValue(i, k + 1) * (1.0 - u) + latticeValue(i + 1, k + 1) * u;
  return near * (1.0 - v) + far * v;
}

/// Ridges where the noise crosses its middle; each octave is finer, and lower in the valleys than
/// on the ridges, as weather leaves it (Musgrave, "Texturing and modeling", 1994).
double ridgedHeight(double x, double z, int octaves) {
  double height = 0.0;
  double amplitude = 0.5;
  double weight = 1.0;
  double frequency = kFirstFrequency;
  for (int octave = 0; octave < octaves; ++octave) {
    const double ridge = 1.0 - std::fabs(2.0 * valueNoise(x * frequency, z * frequency) - 1.0);
    const double signal = ridge * ridge * weight;
    height += signal * amplitude;
    weight = std::fmin(1.0, signal * 2.0);
    amplitude *= 0.5;
    frequency *= 2.0;
  }
  return height;
}

/// As many as the squares can show: finer ones would be noise.
int octavesFor(std::uint32_t squares) {
  int octaves = 1;
  for (double finest = kFirstFrequency; finest * 2.0 <= squares; finest *= 2.0)
    ++octaves;
  return octaves;
}

}  // namespace

TriangleMesh<float> makeTerrain(std::uint32_t squares) {
  const int octaves = octavesFor(squares);
  TriangleMesh<float> mesh;
  mesh.faces.reserve(std::size_t{2} * squares * squares);
  addSurface(mesh, squares, squares, [&](double u, double v) {
    return Vec3d{u * kSize, ridgedHeight(u, v, octaves) * kHeight, (1.0 - v) * kSize};
  });
  return mesh;
}

}  // namespace planetree::bench
