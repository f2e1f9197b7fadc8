#include "tool_run.hpp"

#include <sys/stat.h>

#include <string>

namespace planetree::test {
namespace {

using Import = ToolTest;

/// Two squares as quads, a line, a polygon of two corners, and one with a vertex that does not
/// exist, in COLLADA: a format that assimp reads.
const std::string kSquares = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<library_geometries><geometry id="g"><mesh>
<source id="s"><float_array id="a" count="12">0 0 0 1 0 0 1 1 0 0 1 0</float_array>
<technique_common><accessor source="#a" count="4" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#s"/></vertices>
<lines count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2</p></lines>
<polylist count="1"><input semantic="VERTEX" source="#v" offset="0"/>
<vcount>4</vcount><p>0 1 2 3</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="w">
<node><instance_geometry url="#g"/></node>
<node><translate>0 0 -2</translate><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#w"/></scene></COLLADA>
)";

/// A triangle, a light and a camera.
const std::string kGltf = R"({"asset": {"version": "2.0"},
"extensionsUsed": ["KHR_lights_punctual"],
"extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional"}]}},
"scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
"cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1.5, "znear": 0.1}}],
"nodes": [{"mesh": 0}, {"camera": 0, "translation": [0.3, 0.3, 3]},
  {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
  "min": [0, 0, 0], "max": [1, 1, 0]}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36,
  "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
)";

void expectSaid(const ToolResult& result, const std::string& words) {
  EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
}

TEST_F(Import, ModelsOfOtherFormatsAreRendered) {
  writeFile("squares.dae", kSquares);
  const ToolResult result = run({"render", "squares.dae", "--size", "24x16"});
  EXPECT_EQ(result.status, 0) << result.err;
  expectSaid(result, "squares.dae: 2 shapes, ");
  expectSaid(result, "  a point, line or curve is left out: it cannot be hit\n");
  expectSaid(result, "tree of 4 objects, built in ");
  EXPECT_TRUE(isPng(readFile("squares.png"), 24, 16));
  const ToolResult inNumbers = run({"render", "squares.dae", "--json", "-q", "--size", "8"});
  EXPECT_NE(inNumbers.out.find("\"mode\": \"ao\""), std::string::npos) << inNumbers.out;
}

TEST_F(Import, FormatsWithMaterialsHaveTheirLightsAndTheirCameraInEveryMode) {
  writeFile("scene.gltf", kGltf);
  for (const char* mode : {"whitted", "ao", "normals", "depth", "albedo", "heat"}) {
    const ToolResult result = run({"render", "scene.gltf", "--size", "8", "--mode", mode});
    EXPECT_EQ(result.status, 0) << result.err;
    expectSaid(result, "view: the camera of the scene");
  }
  const ToolResult result = run({"render", "scene.gltf", "--json", "-q", "--size", "8"});
  EXPECT_NE(result.out.find("\"mode\": \"whitted\""), std::string::npos) << result.out;
}

/// Such a file is named by another: whoever opens it waits for ever, or reads without an end.
TEST_F(Import, PipesAndDevicesThatFilesNameAreRefused) {
  ASSERT_EQ(::mkfifo((folder() / "pipe").c_str(), 0600), 0);
  for (const std::string file : {"pipe", "/dev/zero"}) {
    writeFile("scene.json",
              "{\"shapes\": [\n  {\"type\": \"model\", \"file\": \"" + file + "\"}]}");
    const ToolResult result = run({"render", "scene.json", "--size", "8"});
    EXPECT_EQ(result.status, 1) << result.err;
    expectSaid(result, "scene.json:2:29: the model cannot be used: ");
    expectSaid(result, "it is a device or a pipe, not a file");
  }
  writeFile("square.obj", "mtllib pipe\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(run({"render", "square.obj", "--mode", "albedo", "--size", "8"}).status, 0);
  writeFile("piped.gltf",
            R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "uri": "pipe"}]})");
  EXPECT_EQ(run({"render", "piped.gltf", "--size", "8"}).status, 1);
}

TEST_F(Import, RaysMeetEachPlaceOfAMesh) {
  writeFile("squares.dae", kSquares);
  writeFile("rays.csv", "0.5,0.25,5,0,0,-1\n0.5,0.25,-1,0,0,-1\n");
  const ToolResult result = run({"trace", "squares.dae", "rays.csv"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("\n5,0,0,"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("\n1,0,2,"), std::string::npos) << result.out;
}

TEST_F(Import, DamagedModelsAreOneLineOfError) {
  writeFile("squares.dae", kSquares.substr(0, kSquares.size() / 2));
  const ToolResult result = runSmall({"squares.dae"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err.rfind("planetree: squares.dae: it cannot be read: ", 0), 0u) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
}

TEST_F(Import, WhatIsLeftOutOfOwnFormatsIsSaidToo) {
  writeFile(
      "model.obj",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1e300 0 0\nf 1 2 3\nf 1 2 9\nf 1 2\nf 1 2 4\nl 1 2\np 3\n");
  const ToolResult result = runSmall({"model.obj"});
  EXPECT_EQ(result.status, 0) << result.err;
  expectSaid(result, "skipped 2 of 4 faces: face 1 refers to vertex 9, which does not exist, ");
  expectSaid(result, "left out 2 primitives");
  expectSaid(result, "1 coordinate is too large for the precision of the mesh, and infinite in it");
  expectSaid(result, "face 3 has a coordinate that is NaN, infinite or beyond the range of float");
}

}  // namespace
}  // namespace planetree::test
