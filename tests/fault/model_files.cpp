#include "model_files.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>

namespace planetree::test {
namespace {

template <class Number>
std::string textOf(Number number) {
  std::array<char, 64> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

template <class Number>
std::string bytesOf(Number number, std::endian order) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (order != std::endian::native)
    std::reverse(bytes.begin(), bytes.end());
  return {bytes.begin(), bytes.end()};
}

std::string lineOf(const std::string& start, const Vec3f& v) {
  return start + textOf(v.x) + ' ' + textOf(v.y) + ' ' + textOf(v.z) + '\n';
}

std::string lineOf(const std::string& start, const FaceIndices& face, std::uint32_t first) {
  return start + textOf(face[0] + first) + ' ' + textOf(face[1] + first) + ' ' +
         textOf(face[2] + first) + '\n';
}

std::string plyHeader(const TriangleMesh<float>& mesh, const std::string& format) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + textOf(mesh.positions.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         textOf(mesh.faces.size()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
}

std::string plyText(const TriangleMesh<float>& mesh) {
  std::string text = plyHeader(mesh, "ascii");
  for (const Vec3f& position : mesh.positions)
    text += lineOf("", position);
  for (const FaceIndices& face : mesh.faces)
    text += lineOf("3 ", face, 0);
  return text;
}

std::string plyBinary(const TriangleMesh<float>& mesh, std::endian order) {
  std::string bytes =
      plyHeader(mesh, order == std::endian::little ? "binary_little_endian" : "binary_big_endian");
  for (const Vec3f& position : mesh.positions) {
    for (const Axis axis : kAxes)
      bytes += bytesOf(position[axis], order);
  }
  for (const FaceIndices& face : mesh.faces) {
    bytes += '\3';
    for (const std::uint32_t vertex : face)
      bytes += bytesOf(vertex, order);
  }
  return bytes;
}

std::string stlText(const TriangleMesh<float>& mesh) {
  std::string text = "solid model\n";
  for (const FaceIndices& face : mesh.faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t vertex : face)
      text += lineOf("vertex ", mesh.positions[vertex]);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid model\n";
}

std::string stlBinary(const TriangleMesh<float>& mesh) {
  constexpr std::endian kLittle = std::endian::little;
  std::string bytes(80, ' ');
  bytes += bytesOf(static_cast<std::uint32_t>(mesh.faces.size()), kLittle);
  for (const FaceIndices& face : mesh.faces) {
    bytes += std::string(12, '\0');
    for (const std::uint32_t vertex : face) {
      for (const Axis axis : kAxes)
        bytes += bytesOf(mesh.positions[vertex][axis], kLittle);
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string obj(const TriangleMesh<float>& mesh) {
  std::string text;
  for (const Vec3f& position : mesh.positions)
    text += lineOf("v ", position);
  for (const FaceIndices& face : mesh.faces)
    text += lineOf("f ", face, 1);
  return text;
}

std::string off(const TriangleMesh<float>& mesh) {
  std::string text =
      "OFF\n" + textOf(mesh.positions.size()) + ' ' + textOf(mesh.faces.size()) + " 0\n";
  for (const Vec3f& position : mesh.positions)
    text += lineOf("", position);
  for (const FaceIndices& face : mesh.faces)
    text += lineOf("3 ", face, 0);
  return text;
}

}  // namespace

std::vector<ModelFile> modelFilesOf(const TriangleMesh<float>& mesh) {
  return {{"text.ply", plyText(mesh)},
          {"little.ply", plyBinary(mesh, std::endian::little)},
          {"big.ply", plyBinary(mesh, std::endian::big)},
          {"text.stl", stlText(mesh)},
          {"binary.stl", stlBinary(mesh)},
          {"model.obj", obj(mesh)},
          {"model.off", off(mesh)}};
}

std::vector<ModelFile> faultyModelFiles() {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  std::string skipped = corners;
  for (int i = 0; i < 20; ++i)
    skipped += "f 1 2\nf 1 2 9\nl 1 2\nf 1 2 3 4\n";
  return {{"skipped.obj", skipped},
          {"word.obj", corners + "f 1 2 three\n"},
          {"keyword.obj", corners + "curse 1 2 3\n"},
          {"number.off", "OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n"},
          {"short.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n"},
          {"short.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"},
          {"short.stl", "solid model\nfacet normal 0 0 0\nouter loop\nvertex 0 0\n"},
          {"empty.obj", ""},
          {"notes.txt", "There is no model in this file.\n"}};
}

}  // namespace planetree::test
