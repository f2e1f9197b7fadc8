#include "render/still_life.hpp"

#include <planetree/shape/shapes.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace planetree::render {

namespace {

using std::numbers::pi;

// Colours in linear light.
constexpr Vec3f kPlaster{0.80f, 0.77f, 0.72f};
constexpr Vec3f kSand{0.66f, 0.56f, 0.43f};
constexpr Vec3f kTerracotta{0.68f, 0.20f, 0.10f};
constexpr Vec3f kOchre{0.82f, 0.48f, 0.10f};
constexpr Vec3f kTeal{0.07f, 0.36f, 0.38f};
constexpr Vec3f kNight{0.07f, 0.13f, 0.30f};
constexpr Vec3f kRose{0.78f, 0.42f, 0.38f};

constexpr double kStageRadius = 3.7;

/// The point of the plane y = `height` at an angle around the y axis.
Vec3f onCircle(double angle, double radius, double height) {
  return Vec3f(Vec3d{radius * std::cos(angle), height, -radius * std::sin(angle)});
}

/// A place on the stage as the default camera sees it: so far to the right of the middle, so far
/// toward the viewer.
Vec3f spot(double right, double toward) {
  // The view direction of framing.hpp without its height.
  const Vec3d rightward = normalized(Vec3d{0.76, 0.0, -0.55});
  const Vec3d viewerward = normalized(Vec3d{0.55, 0.0, 0.76});
  return Vec3f(rightward * right + viewerward * toward);
}

Vec3f above(const Vec3f& place, float height) {
  return place + Vec3f{0.0f, height, 0.0f};
}

template <class Objects>
void place(StillLife& stillLife, Objects objects, const Vec3f& albedo) {
  stillLife.scene.add(std::move(objects));
  stillLife.albedos.push_back(albedo);
}

void placeStage(StillLife& stillLife) {
  const auto radius = static_cast<float>(kStageRadius);
  place(stillLife,
        std::vector<Cylinder<float>>{
            {.base = {0.0f, -0.3f, 0.0f}, .axis = {0.0f, 0.3f, 0.0f}, .radius = radius},
            {.base = {0.0f, -0.5f, 0.0f}, .axis = {0.0f, 0.2f, 0.0f}, .radius = radius + 0.35f}},
        kPlaster);
}

void placeKnot(StillLife& stillLife) {
  place(stillLife,
        std::vector<Box<float>>{{.lower = {-0.75f, 0.0f, -0.75f}, .upper = {0.75f, 0.5f, 0.75f}},
                                {.lower = {-0.6f, 0.5f, -0.6f}, .upper = {0.6f, 0.62f, 0.6f}}},
        kSand);
  TriangleMesh<float> knot = makeTorusKnot(480, 48, 0.21);
  for (Vec3f& position : knot.positions) {
    // It stands on the plinth, turned toward the viewer.
    const Vec3f turned{0.90f * position.x + 0.44f * position.z, position.y,
                       0.90f * position.z - 0.44f * position.x};
    position = turned * 1.02f + Vec3f{0.0f, 1.83f, 0.0f};
  }
  place(stillLife, std::move(knot), kTerracotta);
}

/// A spiral stair of squares around a column.
void placeStair(StillLife& stillLife) {
  constexpr int kSteps = 22;
  const Vec3f foot = spot(-1.95, -0.9);
  place(stillLife, Cylinder<float>{.base = foot, .axis = {0.0f, 3.0f, 0.0f}, .radius = 0.22f},
        kPlaster);
  place(stillLife, Sphere<float>{.center = above(foot, 3.3f), .radius = 0.34f}, kOchre);
  std::vector<Square<float>> steps;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = i * pi / 7.0;
    const Vec3f radial = onCircle(angle, 1.0, 0.0);
    const Vec3f along = onCircle(angle + pi / 2.0, 1.0, 0.0);
    steps.push_back({.center = above(foot + radial * 0.6f, 0.125f * static_cast<float>(i + 1)),
                     .edgeU = radial * 0.76f,
                     .edgeV = along * 0.36f});
  }
  place(stillLife, std::move(steps), kTeal);
}

void placeCones(StillLife& stillLife) {
  place(stillLife,
        std::vector<Cone<float>>{
            {.base = spot(2.25, -0.75), .axis = {0.0f, 2.2f, 0.0f}, .bottomRadius = 0.72f},
            {.base = spot(1.35, -2.0), .axis = {0.0f, 1.5f, 0.0f}, .bottomRadius = 0.55f}},
        kNight);
  place(stillLife,
        Cone<float>{.base = spot(-2.3, 0.9),
                    .axis = {0.0f, 0.55f, 0.0f},
                    .bottomRadius = 0.62f,
                    .topRadius = 0.4f},
        kRose);
}

void placeSpheres(StillLife& stillLife) {
  place(stillLife, Sphere<float>{.center = above(spot(-2.3, 0.9), 1.0f), .radius = 0.47f},
        kPlaster);
  place(stillLife, Sphere<float>{.center = above(spot(1.55, 1.05), 0.68f), .radius = 0.68f},
        kOchre);
  place(stillLife, Sphere<float>{.center = above(spot(0.45, 1.95), 0.32f), .radius = 0.32f}, kTeal);
}

/// A pile of pipes that the eye can look into: cylinders without caps.
void placePipes(StillLife& stillLife) {
  constexpr float kRadius = 0.28f;
  const Vec3f along = spot(0.35, 1.0);
  const Vec3f beside = normalized(spot(1.0, -0.35));
  const Vec3f first = above(spot(-1.45, 1.3), kRadius);
  const std::vector<Vec3f> bases = {first, first + beside * (2.0f * kRadius),
                                    above(first + beside * kRadius, 1.732f * kRadius)};
  std::vector<Cylinder<float>> pipes;
  for (const Vec3f& base : bases) {
    pipes.push_back({.base = base, .axis = along, .radius = kRadius, .capped = false});
  }
  place(stillLife, std::move(pipes), kRose);
}

/// A row of beads along the rim of the stage, from small to large and back.
void placeBeads(StillLife& stillLife) {
  constexpr int kBeads = 72;
  std::vector<Sphere<float>> beads;
  for (int i = 0; i < kBeads; ++i) {
    const double angle = 2.0 * pi * i / kBeads;
    const double radius = 0.085 + 0.045 * std::cos(6.0 * angle);
    beads.push_back({.center = onCircle(angle, kStageRadius - 0.28, radius),
                     .radius = static_cast<float>(radius)});
  }
  place(stillLife, std::move(beads), kPlaster);
}

std::vector<Vec3f> stageOutline() {
  std::vector<Vec3f> outline;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2.0 * pi * i / 64.0;
    outline.push_back(onCircle(angle, kStageRadius + 0.35, -0.5));
    outline.push_back(onCircle(angle, 0.6 * kStageRadius, 3.64));
  }
  return outline;
}

/// The middle line of the knot.
Vec3d knotCenter(double angle) {
  const double distance = 0.72 + 0.28 * std::cos(3.0 * angle);
  return {distance * std::cos(2.0 * angle), distance * std::sin(2.0 * angle),
          0.36 * std::sin(3.0 * angle)};
}

/// The corners of the tube around the middle line at an angle.
void addRing(TriangleMesh<float>& knot, double angle, std::uint32_t sides, double tubeRadius) {
  constexpr double kStep = 1e-4;
  const Vec3d center = knotCenter(angle);
  const Vec3d along = normalized(knotCenter(angle + kStep) - knotCenter(angle - kStep));
  // The knot never runs along the line to its axis, so this is a frame without twists.
  const Vec3d outward = normalized(center - along * dot(center, along));
  const Vec3d across = cross(along, outward);
  for (std::uint32_t side = 0; side < sides; ++side) {
    const double turn = 2.0 * pi * side / sides;
    knot.positions.push_back(
        Vec3f(center + (outward * std::cos(turn) + across * std::sin(turn)) * tubeRadius));
  }
}

}  // namespace

TriangleMesh<float> makeTorusKnot(std::uint32_t segments, std::uint32_t sides, double tubeRadius) {
  TriangleMesh<float> knot;
  for (std::uint32_t segment = 0; segment < segments; ++segment) {
    addRing(knot, 2.0 * pi * segment / segments, sides, tubeRadius);
    const std::uint32_t ring = segment * sides;
    const std::uint32_t nextRing = (segment + 1) % segments * sides;
    for (std::uint32_t side = 0; side < sides; ++side) {
      const std::uint32_t nextSide = (side + 1) % sides;
      knot.faces.push_back({ring + side, ring + nextSide, nextRing + nextSide});
      knot.faces.push_back({ring + side, nextRing + nextSide, nextRing + side});
    }
  }
  return knot;
}

StillLife makeStillLife() {
  StillLife stillLife;
  placeStage(stillLife);
  placeKnot(stillLife);
  placeStair(stillLife);
  placeCones(stillLife);
  placeSpheres(stillLife);
  placePipes(stillLife);
  placeBeads(stillLife);
  stillLife.outline = stageOutline();
  return stillLife;
}

}  // namespace planetree::render
