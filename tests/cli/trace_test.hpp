#pragma once

#include "tool_run.hpp"

#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace planetree::test {

/// The shortest text that is read back as the same number.
template <class Number>
std::string textOf(Number number) {
  std::array<char, 64> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

/// A heap of random triangles, as a mesh and as an OBJ file of the same numbers.
template <class T>
TriangleMesh<T> randomMesh(std::uint64_t seed, std::uint32_t faceCount) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<float> place(-1.0f, 1.0f);
  TriangleMesh<T> mesh;
  for (std::uint32_t face = 0; face < faceCount; ++face) {
    for (int corner = 0; corner < 3; ++corner)
      mesh.positions.push_back(
          {T(place(generator)), T(place(generator)), T(place(generator)) / T(3)});
    mesh.faces.push_back({3 * face, 3 * face + 1, 3 * face + 2});
  }
  return mesh;
}

template <class T>
std::string objOf(const TriangleMesh<T>& mesh) {
  std::string text;
  for (const Vec3<T>& p : mesh.positions) {
    text += "v ";
    text += textOf(p.x) + ' ' + textOf(p.y) + ' ' + textOf(p.z) + '\n';
  }
  for (const FaceIndices& face : mesh.faces) {
    text += "f ";
    text += textOf(face[0] + 1) + ' ' + textOf(face[1] + 1) + ' ' + textOf(face[2] + 1) + '\n';
  }
  return text;
}

/// Rays from around the mesh, with a few that can hit nothing.
template <class T>
std::vector<Ray<T>> randomRays(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<T> place(T(-1.5), T(1.5));
  const auto random = [&] { return place(generator); };
  std::vector<Ray<T>> rays;
  for (std::size_t i = 0; i < count; ++i) {
    Ray<T> ray{.origin = {random(), random(), random()},
               .direction = {random(), random(), random()}};
    if (i % 3 == 1) {
      ray.tMin = T(-0.5);
      ray.tMax = T(0.75);
    }
    if (i % 50 == 7)
      ray.direction = {};
    if (i % 50 == 8)
      ray.origin.y = std::numeric_limits<T>::quiet_NaN();
    rays.push_back(ray);
  }
  return rays;
}

template <class T>
std::string csvOf(const std::vector<Ray<T>>& rays) {
  std::string text = "ox,oy,oz,dx,dy,dz,tMin,tMax\n";
  for (const Ray<T>& ray : rays) {
    for (const T number : {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x,
                           ray.direction.y, ray.direction.z, ray.tMin})
      text += textOf(number) + ',';
    text += textOf(ray.tMax) + '\n';
  }
  return text;
}

/// What stands before the `count` rays of an N x 8 array.
template <class T>
std::string npyRayHeader(std::size_t count) {
  std::string dictionary = "{'descr': '<f";
  dictionary += textOf(sizeof(T)) + "', 'fortran_order': False, 'shape': (";
  dictionary += textOf(count) + ", 8), }\n";
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(dictionary.size());
  header += '\0';
  return header + dictionary;
}

template <class T>
std::string npyOf(const std::vector<Ray<T>>& rays) {
  static_assert(std::endian::native == std::endian::little);
  std::string bytes = npyRayHeader<T>(rays.size());
  bytes.append(reinterpret_cast<const char*>(rays.data()), rays.size() * sizeof(Ray<T>));
  return bytes;
}

/// The table that the tool is to write for these hits, line by line.
template <class T>
std::string csvOf(const std::vector<Hit<T>>& hits) {
  std::string text = "t,geometry,primitive,u,v,nx,ny,nz\n";
  for (const Hit<T>& hit : hits) {
    text += textOf(hit.t) + ',' + textOf(static_cast<std::int32_t>(hit.geometry)) + ',' +
            textOf(static_cast<std::int32_t>(hit.primitive)) + ',' + textOf(hit.u) + ',' +
            textOf(hit.v) + ',' + textOf(hit.normal.x) + ',' + textOf(hit.normal.y) + ',' +
            textOf(hit.normal.z) + '\n';
  }
  return text;
}

/// The records of a .npy table, behind its header.
template <class T>
std::vector<Hit<T>> hitsOfNpy(const std::string& bytes) {
  constexpr std::size_t kRecordBytes = 6 * sizeof(T) + 8;
  const std::size_t start = 10u + static_cast<unsigned char>(bytes.at(8)) +
                            256u * static_cast<unsigned char>(bytes.at(9));
  EXPECT_EQ((bytes.size() - start) % kRecordBytes, 0u);
  std::vector<Hit<T>> hits((bytes.size() - start) / kRecordBytes);
  const char* from = bytes.data() + start;
  const auto take = [&from](auto& field) {
    std::memcpy(&field, from, sizeof(field));
    from += sizeof(field);
  };
  for (Hit<T>& hit : hits) {
    take(hit.t);
    take(hit.geometry);
    take(hit.primitive);
    take(hit.u);
    take(hit.v);
    take(hit.normal.x);
    take(hit.normal.y);
    take(hit.normal.z);
  }
  return hits;
}

class TraceTest : public ToolTest {
 protected:
  TraceTest() {
    writeModel("roof.obj");
    writeFile("rays.csv", kTwoRays);
  }

  /// `planetree trace roof.obj` with these arguments besides.
  [[nodiscard]] ToolResult trace(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"trace", "roof.obj"});
    return run(std::move(arguments));
  }

  /// One that hits the roof and one that does not, and their hits.
  static constexpr const char* kTwoRays = "0.25,0.5,2,0,0,-1\n5,5,5,0,0,1\n";
  static constexpr const char* kTwoHits =
      "t,geometry,primitive,u,v,nx,ny,nz\n"
      "1.75,0,1,0.25,0.25,0,-0.4472136,0.8944272\n"
      "inf,-1,-1,0,0,0,0,0\n";
};

/// Status 1, nothing on standard output, and one line that names the culprit.
inline void expectFailed(const ToolResult& result, const std::string& named) {
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err.rfind("planetree: ", 0), 0u) << result.err;
  EXPECT_NE(result.err.find(named), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
}

}  // namespace planetree::test
