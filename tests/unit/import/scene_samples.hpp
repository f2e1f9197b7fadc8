#pragma once

#include <string>

/// Small models with materials, textures, lights and cameras, written here byte by byte.
namespace planetree::test {

/// A PNG image of two by two: red and green above blue and white.
[[nodiscard]] std::string fourColours();

/// An image URI that holds those bytes.
[[nodiscard]] std::string embeddedImage();

/// A square of two materials, the first of which has the texture `map_Kd`.
[[nodiscard]] std::string objSquare();
[[nodiscard]] std::string mtlFor(const std::string& colourMap);

/// A glTF document: a square with texture coordinates and all that a material may have, which two
/// nodes place, a point light, a directional light, and a camera within a turned parent. `image` is
/// what stands between the brackets of the image.
[[nodiscard]] std::string gltfScene(const std::string& image);

/// The same as a binary file, with the image in its buffer.
[[nodiscard]] std::string glbScene();

/// A glTF document of one square with one material, which is given by what stands between its
/// brackets.
[[nodiscard]] std::string gltfWithMaterial(const std::string& material);

}  // namespace planetree::test
