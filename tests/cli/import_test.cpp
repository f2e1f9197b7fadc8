#include "tool_run.hpp"

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

void expectSaid(const ToolResult& result, const std::string& words) {
  EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
}

TEST_F(Import, ModelsOfOtherFormatsAreRendered) {
  writeFile("squares.dae", kSquares);
  const ToolResult result = runSmall({"squares.dae"});
  EXPECT_EQ(result.status, 0) << result.err;
  expectSaid(result, "squares.dae: 4 triangles, 8 vertices (Collada, read in ");
  expectSaid(result, "  left out 2 primitives: points, lines and curves cannot be hit\n");
  EXPECT_TRUE(isPng(readFile("squares.png"), 24, 16));
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
