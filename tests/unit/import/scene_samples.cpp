#include "scene_samples.hpp"

#include "sample_models.hpp"

namespace planetree::test {
namespace {

constexpr std::size_t kImageSize = 75;

/// Positions and indices, then texture coordinates, v down, and normals.
std::string sceneBuffer() {
  return squareBuffer() + floats({0, 1, 1, 1, 1, 0, 0, 0}) +
         floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
}

std::string gltfSceneNodes(const std::string& image, const std::string& moreViews) {
  return R"("scene": 0,
"extensionsUsed": ["KHR_lights_punctual"],
"extensions": {"KHR_lights_punctual": {"lights": [
  {"type": "point", "color": [1, 0.5, 0.25], "intensity": 4},
  {"type": "directional", "intensity": 2}]}},
"scenes": [{"nodes": [0, 1, 2, 3, 4, 6]}],
"nodes": [
  {"mesh": 0, "name": "one", "translation": [10, 0, 0]},
  {"mesh": 0, "name": "two", "scale": [2, 2, 2]},
  {"translation": [0, 5, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}},
  {"rotation": [-0.70710678, 0, 0, 0.70710678],
   "extensions": {"KHR_lights_punctual": {"light": 1}}},
  {"rotation": [0, 0.70710678, 0, 0.70710678], "children": [5]},
  {"camera": 0, "translation": [0, 0, 7]},
  {"mesh": 0, "name": "flat", "scale": [1, 0, 1]}],
"cameras": [{"type": "perspective",
  "perspective": {"yfov": 0.9, "aspectRatio": 1.5, "znear": 0.1}}],
"materials": [{"name": "painted",
  "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 0.5], "metallicFactor": 0.25,
    "roughnessFactor": 0.5, "baseColorTexture": {"index": 0}},
  "emissiveFactor": [0.5, 0, 1]}],
"textures": [{"source": 0}],
"images": [{)" +
         image +
         R"(}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 2, "NORMAL": 3},
  "indices": 1, "material": 0}]}],
"bufferViews": [
  {"buffer": 0, "byteOffset": 0, "byteLength": 48},
  {"buffer": 0, "byteOffset": 48, "byteLength": 12},
  {"buffer": 0, "byteOffset": 60, "byteLength": 32},
  {"buffer": 0, "byteOffset": 92, "byteLength": 48})" +
         moreViews +
         R"(],
"accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
   "min": [0, 0, 0], "max": [1, 1, 0]},
  {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
  {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"},
  {"bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC3"}])";
}

}  // namespace

std::string fourColours() {
  return std::string(
      "\x89\x50\x4E\x47\x0D\x0A\x1A\x0A\x00\x00\x00\x0D\x49\x48\x44\x52\x00\x00"
      "\x00\x02\x00\x00\x00\x02\x08\x02\x00\x00\x00\xFD\xD4\x9A\x73\x00\x00\x00"
      "\x12\x49\x44\x41\x54\x78\x9C\x63\xF8\xCF\xC0\xC0\x00\xC2\x0C\xFF\x81\x00"
      "\x00\x1F\xEE\x05\xFB\x0B\xD9\x68\x8B\x00\x00\x00\x00\x49\x45\x4E\x44\xAE"
      "\x42\x60\x82",
      kImageSize);
}

std::string embeddedImage() {
  return "data:image/png;base64,"
         "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAEklEQVR4nGP4z8DAAMIM/4EAAB/"
         "uBfsL2WiLAAAAAElF"
         "TkSuQmCC";
}

std::string objSquare() {
  return R"(mtllib square.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 0 1
o square
usemtl wood
f 1/1/1 2/2/1 3/3/1
usemtl glass
f 1 3 4
)";
}

std::string mtlFor(const std::string& colourMap) {
  return R"(newmtl wood
Ka 0.125 0.25 0.375
Kd 0.5 0.75 1
Ks 0.25 0.5 0.625
Ke 0 0.0625 0
Ns 50
illum 2
map_Kd )" +
         colourMap +
         R"(

newmtl glass
Ka 0 0 0
Kd 0.5 0.5 0.5
Ks 0.75 0.75 0.75
Ns 200
Ni 1.5
d 0.25
Tf 1 0.5 1
illum 7
)";
}

std::string gltfScene(const std::string& image) {
  const std::string buffer = sceneBuffer();
  return gltf(gltfSceneNodes(image, ""), embedded(buffer), buffer.size());
}

std::string glbScene() {
  const std::string view =
      ",\n  {\"buffer\": 0, \"byteOffset\": 140, \"byteLength\": " + std::to_string(kImageSize) +
      "}";
  return glb(gltfSceneNodes(R"("bufferView": 4, "mimeType": "image/png")", view),
             sceneBuffer() + fourColours());
}

std::string gltfWithMaterial(const std::string& material) {
  const std::string buffer = sceneBuffer();
  const std::string nodes = R"("scene": 0,
"extensionsUsed": ["KHR_texture_transform", "KHR_materials_transmission", "KHR_materials_ior",
  "KHR_materials_unlit"],
"scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
"materials": [{)" + material +
                            R"(}],
"textures": [{"source": 0}], "images": [{"uri": ")" +
                            embeddedImage() +
                            R"("}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 2},
  "indices": 1, "material": 0}]}],
"bufferViews": [
  {"buffer": 0, "byteOffset": 0, "byteLength": 48},
  {"buffer": 0, "byteOffset": 48, "byteLength": 12},
  {"buffer": 0, "byteOffset": 60, "byteLength": 32}],
"accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
   "min": [0, 0, 0], "max": [1, 1, 0]},
  {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
  {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"}])";
  return gltf(nodes, embedded(buffer), buffer.size());
}

}  // namespace planetree::test
