#include <planetree/scene.hpp>
#include <planetree/shape/shapes.hpp>

#include "support/byte_stream.hpp"
#include "support/query_promises.hpp"
#include "support/take_numbers.hpp"
#include "support/take_options.hpp"
#include "support/tree_promises.hpp"

#include <variant>
#include <vector>

// Any bytes as spheres, boxes, cones, cylinders, squares and triangles, the options of their tree,
// and some rays.

namespace planetree::fuzz {
namespace {

template <class T>
using AnyShape = std::variant<Sphere<T>, Box<T>, Cone<T>, Cylinder<T>, Square<T>, Triangle<T>>;

template <class T>
AnyShape<T> takeShape(ByteStream& input, NumberTaker<T>& numbers) {
  const unsigned kind = input.takeBelow(8);
  const Vec3<T> first = numbers.takeVector();
  switch (kind) {
    case 0:
      return Sphere<T>{.center = first, .radius = numbers.take()};
    case 1:
      return Box<T>{.lower = first, .upper = numbers.takeVector()};
    case 2:
    case 3: {
      Cone<T> cone{.base = first, .axis = numbers.takeVector()};
      cone.bottomRadius = numbers.take();
      cone.topRadius = numbers.take();
      cone.capped = kind == 2;
      return cone;
    }
    case 4:
    case 5: {
      Cylinder<T> cylinder{.base = first, .axis = numbers.takeVector()};
      cylinder.radius = numbers.take();
      cylinder.capped = kind == 4;
      return cylinder;
    }
    case 6: {
      const Vec3<T> edgeU = numbers.takeVector();
      return Square<T>{.center = first, .edgeU = edgeU, .edgeV = numbers.takeVector()};
    }
    default: {
      const Vec3<T> second = numbers.takeVector();
      return Triangle<T>{.a = first, .b = second, .c = numbers.takeVector()};
    }
  }
}

template <class T>
void check(ByteStream& input) {
  const BuildOptions options = takeBuildOptions(input);
  NumberTaker<T> numbers(input);
  std::vector<AnyShape<T>> shapes;
  const unsigned shapeCount = input.takeBelow(13);
  for (unsigned i = 0; i < shapeCount; ++i)
    shapes.push_back(takeShape(input, numbers));
  // The first shape is a geometry of its own, with a mask.
  const QueryOptions query = takeQueryOptions(input);
  Scene<T> scene;
  if (!shapes.empty()) {
    scene.add(shapes.front(), {.mask = input.takeByte()});
    shapes.erase(shapes.begin());
  }
  scene.add(shapes);
  const auto tree = buildOrRefuse(scene, options);
  if (!tree)
    return;
  std::vector<Ray<T>> rays;
  do
    rays.push_back(takeRay(input, numbers));
  while (!input.isEmpty() && rays.size() < 16);
  for (const Ray<T>& ray : rays)
    checkRay(*tree, ray, query);
  checkBatch(*tree, rays, query);
}

}  // namespace
}  // namespace planetree::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace planetree::fuzz;
  ByteStream input(data, size);
  if (input.takeBelow(2) == 0)
    check<float>(input);
  else
    check<double>(input);
  return 0;
}
