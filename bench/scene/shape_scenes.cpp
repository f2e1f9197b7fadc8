#include "bench/scene/shape_scenes.hpp"

#include "bench/support/random.hpp"

#include <planetree/shape/shapes.hpp>

#include <cmath>
#include <utility>

namespace planetree::bench {

namespace {

constexpr std::uint64_t kSphereSeed = 20'260'201u;
constexpr std::uint64_t kMixedSeed = 20'260'202u;

/// Random places in a cube with one unit of volume for each shape, and random sizes.
class Scatter {
 public:
  Scatter(std::uint64_t seed, std::size_t count)
      : random_(seed), side_(std::cbrt(static_cast<double>(count))) {}

  /// Small numbers are as likely as large ones, each to its own scale.
  float size(double least, double most) {
    return static_cast<float>(least * std::pow(most / least, random_.unit()));
  }

  Vec3f place() {
    // One statement for each number: the order of a call's arguments is the compiler's choice.
    const double x = random_.between(0.0, side_);
    const double y = random_.between(0.0, side_);
    const double z = random_.between(0.0, side_);
    return Vec3f(Vec3d{x, y, z});
  }

  Vec3f direction() { return Vec3f(random_.direction()); }

 private:
  Random random_;
  double side_;
};

Sphere<float> makeSphere(Scatter& scatter) {
  const Vec3f center = scatter.place();
  return {.center = center, .radius = scatter.size(0.05, 0.4)};
}

Box<float> makeBox(Scatter& scatter) {
  const Vec3f center = scatter.place();
  Vec3f half;
  for (const Axis axis : kAxes)
    half[axis] = scatter.size(0.05, 0.4);
  return {.lower = center - half, .upper = center + half};
}

Cylinder<float> makeCylinder(Scatter& scatter) {
  const Vec3f base = scatter.place();
  const Vec3f direction = scatter.direction();
  const float height = scatter.size(0.1, 0.8);
  return {.base = base, .axis = direction * height, .radius = scatter.size(0.05, 0.3)};
}

Cone<float> makeCone(Scatter& scatter) {
  const Vec3f base = scatter.place();
  const Vec3f direction = scatter.direction();
  const float height = scatter.size(0.1, 0.8);
  return {.base = base, .axis = direction * height, .bottomRadius = scatter.size(0.05, 0.3)};
}

Square<float> makeSquare(Scatter& scatter) {
  const Vec3f center = scatter.place();
  const Vec3f normal = scatter.direction();
  const Vec3f inPlane = normalized(cross(normal, scatter.direction()));
  const float side = scatter.size(0.1, 0.8);
  return {.center = center, .edgeU = inPlane * side, .edgeV = cross(normal, inPlane) * side};
}

VirtualShape makeMixedShape(Scatter& scatter, std::size_t number) {
  switch (number % 5) {
    case 0:
      return makeGeometry(makeSphere(scatter));
    case 1:
      return makeGeometry(makeBox(scatter));
    case 2:
      return makeGeometry(makeCylinder(scatter));
    case 3:
      return makeGeometry(makeCone(scatter));
    default:
      return makeGeometry(makeSquare(scatter));
  }
}

}  // namespace

std::vector<Sphere<float>> makeSpheres(std::size_t count) {
  Scatter scatter(kSphereSeed, count);
  std::vector<Sphere<float>> spheres;
  spheres.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    spheres.push_back(makeSphere(scatter));
  return spheres;
}

std::vector<VirtualShape> makeMixedShapes(std::size_t count) {
  Scatter scatter(kMixedSeed, count);
  std::vector<VirtualShape> shapes;
  shapes.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    shapes.push_back(makeMixedShape(scatter, i));
  return shapes;
}

std::vector<Vec3f> boxCorners(const BenchScene& scene) {
  std::vector<Vec3f> corners;
  corners.reserve(2 * scene.objects().size());
  const auto add = [&](const auto& shapes) {
    for (const auto& shape : shapes) {
      const Box3 bounds = objectBounds(shape);
      corners.push_back(bounds.lower);
      corners.push_back(bounds.upper);
    }
  };
  add(scene.spheres);
  add(scene.shapes);
  return corners;
}

BenchScene makeShapeScene(std::string_view name) {
  BenchScene scene;
  scene.name = name;
  if (name == kShapeScenes[0])
    scene.spheres = makeSpheres();
  else
    scene.shapes = makeMixedShapes();
  frameScene(scene, boxCorners(scene));
  return scene;
}

}  // namespace planetree::bench
