#include "sample_models.hpp"

#include <array>
#include <bit>
#include <cstdint>

namespace planetree::test {
namespace {

/// Least significant byte first.
template <class Number>
std::string littleEndian(Number number) {
  std::string bytes;
  for (unsigned shift = 0; shift < 8 * sizeof(Number); shift += 8)
    bytes += static_cast<char>((number >> shift) & 0xFFu);
  return bytes;
}

std::string littleEndian(float number) {
  return littleEndian(std::bit_cast<std::uint32_t>(number));
}

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto byte = i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u;
      word = word << 8 | byte;
    }
    for (std::size_t j = 0; j < 4; ++j) {
      const bool isPadding = i + j > bytes.size();
      text += isPadding ? '=' : kDigits[(word >> (18 - 6 * j)) & 63u];
    }
  }
  return text;
}

std::string paddedTo4(std::string bytes, char padding) {
  while (bytes.size() % 4 != 0)
    bytes += padding;
  return bytes;
}

std::string studioChunk(std::uint16_t id, const std::string& content) {
  return littleEndian(id) + littleEndian(static_cast<std::uint32_t>(content.size() + 6)) + content;
}

}  // namespace

std::string floats(std::initializer_list<float> numbers) {
  std::string bytes;
  for (const float number : numbers)
    bytes += littleEndian(number);
  return bytes;
}

std::string offCube() {
  return "OFF\n8 6 0\n"
         "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
         "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
}

std::string squareBuffer() {
  constexpr std::array<float, 12> kPositions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  constexpr std::array<std::uint16_t, 6> kIndices = {0, 1, 2, 0, 2, 3};
  std::string bytes;
  for (const float coordinate : kPositions)
    bytes += littleEndian(coordinate);
  for (const std::uint16_t index : kIndices)
    bytes += littleEndian(index);
  return bytes;
}

std::string gltfNodes() {
  // The second node is twice as large, turned by 90 degrees about z, and its parent moves it.
  return R"("scene": 0,
"scenes": [{"nodes": [0, 1]}],
"nodes": [
  {"mesh": 0, "translation": [10, 0, 0]},
  {"translation": [0, 0, 5], "children": [2]},
  {"mesh": 0, "scale": [2, 2, 2], "rotation": [0, 0, 0.70710678, 0.70710678]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
"bufferViews": [
  {"buffer": 0, "byteOffset": 0, "byteLength": 48},
  {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
"accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
   "min": [0, 0, 0], "max": [1, 1, 0]},
  {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}])";
}

std::string gltf(const std::string& nodes, const std::string& bufferUri, std::size_t bufferSize) {
  const std::string uri = bufferUri.empty() ? "" : "\"uri\": \"" + bufferUri + "\", ";
  return "{\"asset\": {\"version\": \"2.0\"},\n\"buffers\": [{" + uri +
         "\"byteLength\": " + std::to_string(bufferSize) + "}],\n" + nodes + "}\n";
}

std::string embedded(const std::string& buffer) {
  return "data:application/octet-stream;base64," + base64(buffer);
}

std::string glb(const std::string& nodes, const std::string& buffer) {
  const std::string json = paddedTo4(gltf(nodes, "", buffer.size()), ' ');
  const std::string data = paddedTo4(buffer, '\0');
  const auto size = [](const std::string& chunk) {
    return littleEndian(static_cast<std::uint32_t>(chunk.size()));
  };
  const std::string chunks =
      size(json) + "JSON" + json + size(data) + std::string("BIN\0", 4) + data;
  return "glTF" + littleEndian(std::uint32_t{2}) +
         littleEndian(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

std::string collada() {
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="square"><mesh>
<source id="points"><float_array id="numbers" count="12">0 0 0 100 0 0 100 100 0 0 100 0</float_array>
<technique_common><accessor source="#numbers" count="4" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source>
<vertices id="corners"><input semantic="POSITION" source="#points"/></vertices>
<polylist count="1"><input semantic="VERTEX" source="#corners" offset="0"/>
<vcount>4</vcount><p>0 1 2 3</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="scene">
<node id="here"><instance_geometry url="#square"/></node>
<node id="there"><translate>0 0 700</translate><instance_geometry url="#square"/></node>
</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
)";
}

std::string threeDStudio() {
  constexpr std::array<float, 9> kPositions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::string vertices = littleEndian(std::uint16_t{3});
  for (const float coordinate : kPositions)
    vertices += littleEndian(coordinate);
  std::string faces = littleEndian(std::uint16_t{1});
  for (const std::uint16_t word : std::array<std::uint16_t, 4>{0, 1, 2, 0})
    faces += littleEndian(word);
  const std::string mesh =
      studioChunk(0x4100, studioChunk(0x4110, vertices) + studioChunk(0x4120, faces));
  const std::string object = studioChunk(0x4000, std::string("triangle\0", 9) + mesh);
  return studioChunk(0x4D4D, studioChunk(0x3D3D, object));
}

std::vector<SampleModel> sampleModels() {
  const std::string buffer = squareBuffer();
  return {{"square.gltf", gltf(gltfNodes(), embedded(buffer), buffer.size())},
          {"square.glb", glb(gltfNodes(), buffer)},
          {"square.dae", collada()},
          {"triangle.3ds", threeDStudio()}};
}

}  // namespace planetree::test
