#include <planetree/build_tree.hpp>
#include <planetree/scene.hpp>
#include <planetree/shape/shapes.hpp>

#include "support/closed_meshes.hpp"
#include "support/hard_cases.hpp"

#include "support/byte_stream.hpp"
#include "support/query_promises.hpp"
#include "support/take_numbers.hpp"
#include "support/take_options.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

// Any bytes as rays through a few trees, alone and as batches.

namespace planetree::fuzz {
namespace {

template <class T>
struct Trees {
  KdTree<Face<T>> cube;  ///< closed, from -1 to 1
  KdTree<Face<T>> soup;
  KdTree<Face<T>> plane;  ///< all faces in one plane
  KdTree<AnyObject<T>> mixture;

  /// The same in every run of the program.
  static const Trees& get() {
    static const Trees trees = make();
    return trees;
  }

 private:
  static Trees make() {
    BuildOptions options;
    options.threadCount = 1;
    options.leafSize = 2;
    options.cost.faceCost = 0.5;  // worth some splits
    const auto cube = test::placed<T>("cube", test::gridCube(2), 1.0, {}, 0.9).mesh;
    const auto soup = test::detail::soup<T>(1, 30, 0.5);
    Scene<T> scene;
    scene.add(soup, {.mask = 1});
    scene.add(std::vector<Sphere<T>>{{{0, 0, 0}, T(0.5)}, {{1, 0, 0}, T(0.5)}}, {.mask = 2});
    scene.add(Box<T>{}, {.mask = 4});
    scene.add(Cone<T>{.base = {T(-0.5), 0, 0}}, {.mask = 1});
    scene.add(Cylinder<T>{.base = {0, T(-0.5), 0}, .radius = T(0.25), .capped = false});
    scene.add(cube, {.mask = 8});
    return {buildTree(cube, options), buildTree(soup, options),
            buildTree(test::detail::grid<T>(4, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), options),
            buildTree(scene, options)};
  }
};

/// A line enters a closed mesh as often as it leaves it, and a ray from inside does not get out.
template <class T>
void checkClosed(const KdTree<Face<T>>& cube, Ray<T> ray) {
  if (!isWithinLimits(ray, cube.bounds()) || !test::pointsSomewhere(ray))
    return;
  ray.tMin = T(0);
  ray.tMax = std::numeric_limits<T>::infinity();
  const auto details = [&ray] { return describe(ray); };
  bool isInside = true;
  for (const Axis axis : kAxes)
    isInside = isInside && std::abs(ray.origin[axis]) < T(1);
  if (isInside)
    require(cube.isOccluded(ray), "no ray leaves a closed mesh", details);

  ray.tMin = -ray.tMax;
  int winding = 0;
  QueryOptions crossings;
  crossings.crossings = true;
  for (const auto& hit : test::bruteForceHits(cube, ray, crossings))
    winding += dot(hit.normal, ray.direction) < T(0) ? 1 : -1;
  require(winding == 0, "a line enters a closed mesh as often as it leaves it", details);
}

template <Object O>
void check(const KdTree<O>& tree, const std::vector<Ray<ScalarOf<O>>>& rays,
           const QueryOptions& query) {
  // Rays of a row are alike: the first is looked at closely, all are in the batch.
  for (std::size_t i = 0; i < rays.size(); i += 8)
    checkRay(tree, rays[i], query);
  checkBatch(tree, rays, query);
}

/// Rays, some of them rows of such as differ by a little each, as those of a picture do.
template <class T>
std::vector<Ray<T>> takeRays(ByteStream& input) {
  constexpr std::size_t kMostRays = 96;
  NumberTaker<T> numbers(input);
  std::vector<Ray<T>> rays;
  do {
    Ray<T> ray = takeRay(input, numbers);
    const std::uint8_t row = input.takeByte();
    rays.push_back(ray);
    if (row < 128)
      continue;
    const Vec3<T> turn = numbers.takeVector() / T(64);
    const Vec3<T> step = (row & 1u) != 0 ? numbers.takeVector() / T(64) : Vec3<T>{};
    for (unsigned i = 0; i < (row & 63u); ++i) {
      ray.direction = ray.direction + turn;
      ray.origin = ray.origin + step;
      rays.push_back(ray);
    }
  } while (!input.isEmpty() && rays.size() < kMostRays);
  return rays;
}

template <class T>
void checkAll(ByteStream& input) {
  const unsigned subject = input.takeBelow(4);
  const QueryOptions query = takeQueryOptions(input);
  const std::vector<Ray<T>> rays = takeRays<T>(input);
  const Trees<T>& trees = Trees<T>::get();
  if (subject == 0) {
    check(trees.cube, rays, query);
    for (const Ray<T>& ray : rays)
      checkClosed(trees.cube, ray);
  }
  if (subject == 1)
    check(trees.soup, rays, query);
  if (subject == 2)
    check(trees.plane, rays, query);
  if (subject == 3)
    check(trees.mixture, rays, query);
}

}  // namespace
}  // namespace planetree::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace planetree::fuzz;
  ByteStream input(data, size);
  if (input.takeBelow(2) == 0)
    checkAll<float>(input);
  else
    checkAll<double>(input);
  return 0;
}
