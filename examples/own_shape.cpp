// A shape of your own beside the shapes of the library, in one tree.
#include <planetree/planetree.hpp>

#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

/// The disc of the given radius in the plane z = height.
struct Disc {
  using Scalar = double;
  double height;
  double radius;

  planetree::Box3 bounds() const {
    planetree::Box3 box;
    box.extend(planetree::Vec3d{-radius, -radius, height});
    box.extend(planetree::Vec3d{radius, radius, height});
    return box;
  }

  std::optional<planetree::Hitd> intersect(const planetree::Rayd& ray, double tMin,
                                           double tMax) const noexcept {
    const double t = (height - ray.origin.z) / ray.direction.z;
    const double distance = std::hypot(ray.at(t).x, ray.at(t).y);
    if (!(t >= tMin && t <= tMax && distance <= radius))
      return std::nullopt;
    return planetree::Hitd{.t = t, .u = distance / radius, .normal = {0, 0, 1}};
  }
};

int main() {
  planetree::Scene<double> scene;
  const auto spheres = scene.add(std::vector<planetree::Sphere<double>>{{{0, 0, 0}, 1}});
  const auto discs = scene.add(std::vector<Disc>{{-2, 3}, {2, 0.5}});
  const auto tree = planetree::buildTree(scene);

  const auto aside = tree.findIntersection({{2, 0, 5}, {0, 0, -1}});
  const auto middle = tree.findIntersection({{0.75, 0, 5}, {0, 0, -1}});
  if (!aside || !middle)
    return 1;
  std::printf("beside the sphere: geometry %u, primitive %u at t = %g\n", aside->geometry,
              aside->primitive, aside->t);
  std::printf("onto the sphere: geometry %u at t = %g\n", middle->geometry, middle->t);
  const bool isRight = aside->geometry == discs && aside->primitive == 0 && aside->t == 7 &&
                       middle->geometry == spheres;
  return isRight ? 0 : 1;
}
