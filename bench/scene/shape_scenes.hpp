#pragma once

#include "bench/scene/load_scene.hpp"
#include "bench/scene/scene_objects.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

/// Scenes of shapes, which no mesh file holds. They are the same everywhere but for the rounding of
/// the mathematical functions, and never change: figures of different years are compared on them.
///
/// Both fill a cube evenly, with one shape for each unit of volume: no builder can win much by a
/// clever division, so that what is compared is how fast shapes are reached and tested.
namespace planetree::bench {

/// The names that stand for these scenes where otherwise a file is named.
inline constexpr std::array<std::string_view, 2> kShapeScenes = {"spheres", "shapes"};

inline constexpr std::size_t kSphereCount = 1'000'000;
inline constexpr std::size_t kMixedShapeCount = 250'000;

/// Spheres with radii from 0.05 to 0.4, as particles are: stored by value, one after the other.
[[nodiscard]] std::vector<Sphere<float>> makeSpheres(std::size_t count = kSphereCount);

/// Spheres, boxes, cylinders, cones and squares in turn, up to about one unit in size, and turned
/// any way if they can be: each on the heap, behind a virtual base.
[[nodiscard]] std::vector<VirtualShape> makeMixedShapes(std::size_t count = kMixedShapeCount);

/// The lower and the upper corner of the box of each shape of a scene: what to frame.
[[nodiscard]] std::vector<Vec3f> boxCorners(const BenchScene& scene);

/// One of `kShapeScenes`, looked at from outside.
[[nodiscard]] BenchScene makeShapeScene(std::string_view name);

}  // namespace planetree::bench
