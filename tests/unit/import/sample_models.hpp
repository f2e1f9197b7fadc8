#pragma once

#include <initializer_list>
#include <string>
#include <vector>

/// Small models, written here byte by byte.
namespace planetree::test {

struct SampleModel {
  std::string name;  ///< with the extension of its format
  std::string bytes;
};

/// Floats as files have them, least significant byte first.
[[nodiscard]] std::string floats(std::initializer_list<float> numbers);

/// A cube of six quads, from (0, 0, 0) to (1, 1, 1).
[[nodiscard]] std::string offCube();

/// What stands between the brackets of a glTF document beside "asset" and "buffers": a mesh of one
/// square in the plane z = 0, from (0, 0) to (1, 1), of which two nodes make use.
[[nodiscard]] std::string gltfNodes();

/// The square's buffer: four positions, then six indices of 16 bits.
[[nodiscard]] std::string squareBuffer();

/// A glTF document with one buffer.
[[nodiscard]] std::string gltf(const std::string& nodes, const std::string& bufferUri,
                               std::size_t bufferSize);

/// The buffer as a URI that holds its bytes.
[[nodiscard]] std::string embedded(const std::string& buffer);

/// The same document and buffer as one binary file.
[[nodiscard]] std::string glb(const std::string& nodes, const std::string& buffer);

/// A square like that of glTF as a polygon with four corners, placed twice; in centimetres, z up.
[[nodiscard]] std::string collada();

/// A triangle in chunks of 3D Studio.
[[nodiscard]] std::string threeDStudio();

/// One of each format that assimp reads, with nothing beside it in the folder.
[[nodiscard]] std::vector<SampleModel> sampleModels();

}  // namespace planetree::test
