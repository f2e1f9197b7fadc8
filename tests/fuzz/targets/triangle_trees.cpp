#include <planetree/mesh/triangle_mesh.hpp>

#include "support/byte_stream.hpp"
#include "support/query_promises.hpp"
#include "support/take_numbers.hpp"
#include "support/take_options.hpp"
#include "support/tree_promises.hpp"

#include <vector>

// Any bytes as a mesh, the options of its tree, and some rays.

namespace planetree::fuzz {
namespace {

template <class T>
TriangleMesh<T> takeMesh(ByteStream& input, NumberTaker<T>& numbers) {
  TriangleMesh<T> mesh;
  const unsigned vertexCount = input.takeBelow(33);
  const unsigned faceCount = input.takeBelow(65);
  for (unsigned i = 0; i < vertexCount; ++i)
    mesh.positions.push_back(numbers.takeVector());
  for (unsigned i = 0; i < faceCount; ++i) {
    FaceIndices face{};
    // Some corners beyond the last vertex, and some far beyond it.
    for (std::uint32_t& corner : face) {
      corner = input.takeByte();
      corner = corner == 255 ? input.take<std::uint32_t>() : corner % (vertexCount + 1);
    }
    mesh.faces.push_back(face);
  }
  return mesh;
}

template <class T>
void check(ByteStream& input) {
  const BuildOptions options = takeBuildOptions(input);
  NumberTaker<T> numbers(input);
  const TriangleMesh<T> mesh = takeMesh(input, numbers);
  const auto tree = buildOrRefuse(mesh.view(), options);
  if (!tree)
    return;
  const QueryOptions query = takeQueryOptions(input);
  std::vector<Ray<T>> rays;
  do
    rays.push_back(takeRay(input, numbers));
  while (!input.isEmpty() && rays.size() < 16);
  for (const Ray<T>& ray : rays)
    checkRay(*tree, ray, query);
  // Sixteen in a row may be taken along together.
  for (std::size_t i = 0; rays.size() < 32; ++i)
    rays.push_back(rays[i]);
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
