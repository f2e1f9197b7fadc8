#include "unit/scene/ray_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace planetree::test {
namespace {

using scene::MeshShape;
using scene::SceneDescription;

const MeshShape& meshOf(const SceneDescription& scene, std::size_t shape = 0) {
  return *std::get<std::shared_ptr<const MeshShape>>(scene.shapes.at(shape).shape);
}

const std::string kPoints = "points = ((0,0,0), (1,0,0), (1,1,0), (0,1,0)); ";

void expectNear(const Vec3d& a, const Vec3d& b) {
  constexpr double kTolerance = 1e-12;
  EXPECT_NEAR(a.x, b.x, kTolerance);
  EXPECT_NEAR(a.y, b.y, kTolerance);
  EXPECT_NEAR(a.z, b.z, kTolerance);
}

TEST(RayMesh, HasPointsAndFaces) {
  const SceneDescription scene = readStatements("translate(1, 2, 3, trimesh { name = m; " +
                                                kPoints + "faces = ((0, 1, 2), (0, 2, 3)); })");
  const MeshShape& mesh = meshOf(scene);
  EXPECT_EQ(mesh.positions, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.coordinates.empty());
  EXPECT_TRUE(mesh.vertexMaterials.empty());
  EXPECT_TRUE(mesh.faceMaterials.empty());
  EXPECT_EQ(scene.shapes[0].name, "m");
  EXPECT_EQ(scene.shapes[0].placement.origin(), (Vec3d{1, 2, 3}));
}

TEST(RayMesh, MayBeCalledPolymeshAndHaveFacesFirst) {
  const SceneDescription scene = readStatements("polymesh { faces = ((0, 1, 2)) " + kPoints + "}");
  EXPECT_EQ(meshOf(scene).faces, (std::vector<FaceIndices>{{0, 1, 2}}));
}

TEST(RayMesh, CutsPolygonsIntoFansFromTheirFirstCorner) {
  const SceneDescription scene = readStatements(
      "trimesh { points = ((0,0,0),(1,0,0),(2,1,0),(1,2,0),(0,2,0),(-1,1,0));"
      "faces = ((2,3,4,5,0,1), (0,1,2), (3,2,1,0)) }");
  EXPECT_EQ(meshOf(scene).faces,
            (std::vector<FaceIndices>{
                {2, 3, 4}, {2, 4, 5}, {2, 5, 0}, {2, 0, 1}, {0, 1, 2}, {3, 2, 1}, {3, 1, 0}}));
}

TEST(RayMesh, HasNormalsAndTextureCoordinatesOfPoints) {
  const SceneDescription scene =
      readStatements("trimesh { " + kPoints +
                     "faces = ((0,1,2)); normals = ((0,0,1),(0,0,2),(1,0,0),(0,0,0));"
                     "texture_uv = ((0,0), (1,0), (1,1), (0,1.5)) }");
  EXPECT_EQ(meshOf(scene).normals,
            (std::vector<Vec3d>{{0, 0, 1}, {0, 0, 2}, {1, 0, 0}, {0, 0, 0}}));
  ASSERT_EQ(meshOf(scene).coordinates.size(), 4u);
  EXPECT_EQ(meshOf(scene).coordinates[3], (std::array<double, 2>{0, 1.5}));
}

TEST(RayMesh, HasMaterialsOfPointsThatInheritFromItsOwn) {
  const SceneDescription scene = readStatements(
      "material = { name = red; diffuse = (1, 0, 0) }"
      "trimesh { material = { index = 2 }; " +
      kPoints +
      "faces = ((0,1,2)); materials = (red, { diffuse = (0, 1, 0) }, {}, { ambient = (1,1,1); }) "
      "}");
  const MeshShape& mesh = meshOf(scene);
  ASSERT_EQ(mesh.vertexMaterials.size(), 4u);
  const auto material = [&](std::size_t i) { return scene.materials.at(mesh.vertexMaterials[i]); };
  EXPECT_EQ(material(0).name, "red");
  EXPECT_EQ(material(0).index.value, 1.0);
  EXPECT_EQ(material(1).diffuse.value, (Vec3d{0, 1, 0}));
  EXPECT_EQ(material(1).index.value, 2.0);
  EXPECT_EQ(mesh.vertexMaterials[2], scene.shapes[0].material);
  EXPECT_EQ(material(3).diffuse.value, (Vec3d{1, 0, 0}));
  EXPECT_EQ(material(3).ambient.value, (Vec3d{1, 1, 1}));
}

TEST(RayMesh, MakesNormalsOfTheUnitNormalsAroundAPoint) {
  // Two triangles at a right angle, one four times as large: each counts the same.
  const SceneDescription scene = readStatements(
      "trimesh { gennormals; points = ((0,0,0), (1,0,0), (0,1,0), (0,0,4), (9,9,9));"
      "faces = ((0, 1, 2), (0, 2, 3)) }");
  const double half = std::sqrt(0.5);
  const MeshShape& mesh = meshOf(scene);
  ASSERT_EQ(mesh.normals.size(), 5u);
  expectNear(mesh.normals[0], {half, 0, half});
  expectNear(mesh.normals[1], {0, 0, 1});
  expectNear(mesh.normals[2], {half, 0, half});
  expectNear(mesh.normals[3], {1, 0, 0});
  expectNear(mesh.normals[4], {0, 0, 0});  // no face has it
}

TEST(RayMesh, MakesNormalsOfFacesWithoutAreaToo) {
  const SceneDescription scene = readStatements(
      "trimesh { gennormals points = ((0,0,0), (1,0,0), (0,1,0), (2,0,0));"
      "faces = ((0, 1, 3), (0, 1, 2), (0, 0, 0)) }");
  for (std::size_t i = 0; i < 3; ++i)
    expectNear(meshOf(scene).normals[i], {0, 0, 1});
  expectNear(meshOf(scene).normals[3], {0, 0, 0});
}

TEST(RayMesh, GeneratedNormalsTakeThePlaceOfOthers) {
  const SceneDescription scene =
      readStatements("trimesh { normals = ((1,0,0), (1,0,0), (1,0,0), (1,0,0)); " + kPoints +
                     "gennormals; faces = ((0,1,2,3)) }");
  expectNear(meshOf(scene).normals[0], {0, 0, 1});
  EXPECT_EQ(scene.remarks.size(), 1u);
}

TEST(RayMesh, WithoutFacesIsRemarkedOn) {
  const SceneDescription scene = readStatements("trimesh {} trimesh { points = () faces = () }");
  EXPECT_EQ(scene.remarks, (std::vector<std::string>{"test.ray:2:1: the mesh has no faces",
                                                     "test.ray:2:12: the mesh has no faces"}));
}

TEST(RayMesh, RefusesCornersThatDoNotExist) {
  const std::string problem =
      ": expected the number of one of the 4 points, found \"4\". Corners are counted from 0 in "
      "the "
      "order of the points";
  EXPECT_EQ(errorOf("trimesh { " + kPoints + "\nfaces = ((0,1,2), (0,2,4)) }"),
            "test.ray:3:24" + problem);
  EXPECT_EQ(errorOf("trimesh {\nfaces = ((0,1,2), (0,4,5)); " + kPoints + "}"),
            "test.ray:3:22" + problem);
  for (const std::string index :
       {"4294967295", "4294967296", "4294967297", "99999999999999999999"}) {
    EXPECT_EQ(errorOf("trimesh { faces = ((" + index + ", 0, 1)) " + kPoints + "}"),
              "test.ray:2:21: expected the number of one of the 4 points, found \"" + index +
                  "\". Corners are counted from 0 in the order of the points");
  }
  const std::string advice = ". Corners are counted from 0 in the order of the points";
  EXPECT_EQ(errorOf("trimesh { " + kPoints + "faces = ((0,-1,2)) }"),
            "test.ray:2:70: expected the number of a point, which is not negative, found \"-1\"" +
                advice);
  EXPECT_EQ(
      errorOf("trimesh { faces = ((0, 1.5, 2)) }"),
      "test.ray:2:24: expected the number of a point, which is whole, found \"1.5\"" + advice);
  EXPECT_EQ(errorOf("trimesh { faces = ((0, a, 2)) }"),
            "test.ray:2:24: expected the number of a point, found \"a\"" + advice);
}

TEST(RayMesh, RefusesFacesOfFewCorners) {
  const std::string advice = ". Leave it out, or add the corners that are missing";
  EXPECT_EQ(errorOf("trimesh { " + kPoints + "faces = ((0,1,2), (1,2)) }"),
            "test.ray:2:76: expected a face of three corners or more, found one of 2" + advice);
  EXPECT_EQ(errorOf("trimesh { faces = (()) }"),
            "test.ray:2:20: expected a face of three corners or more, found one of 0" + advice);
}

TEST(RayMesh, RefusesOtherCountsThanThatOfThePoints) {
  const auto wrong = [](const std::string& what, int count) {
    return "test.ray:3:1: expected as many " + what + " as points, which are 4, found " +
           std::to_string(count) + ". Each point takes one, in the order of the points";
  };
  EXPECT_EQ(errorOf("trimesh { " + kPoints + "\nnormals = ((0,0,1)) }"), wrong("normals", 1));
  EXPECT_EQ(errorOf("trimesh { " + kPoints + "\nnormals = () }"), wrong("normals", 0));
  EXPECT_EQ(errorOf("trimesh {\nmaterials = ({}, {}, {}, {}, {})\n" + kPoints + "}"),
            wrong("materials", 5));
  EXPECT_EQ(errorOf("trimesh {\ntexture_uv = ((0, 0), (0, 1))\n" + kPoints + "}"),
            wrong("texture coordinates", 2));
}

TEST(RayMesh, IsToldEverythingOnce) {
  for (const std::string list : {"points", "faces", "normals", "materials", "texture_uv"}) {
    EXPECT_EQ(
        errorOf("trimesh { " + list + " = ();\n" + list + " = () }"),
        "test.ray:3:1: \"" + list +
            "\" of \"trimesh\" is given a second time, after line 2, column 11. Leave out one "
            "of them");
  }
}

TEST(RayMesh, TellsWhatItExpects) {
  EXPECT_EQ(errorOf("trimesh { points = ((0,0,0) (1,0,0)) }"),
            "test.ray:2:29: expected ')' or ',' between points, found '('. A list looks like (..., "
            "...)");
  EXPECT_EQ(errorOf("trimesh { points = ((0,0,0),) }"),
            "test.ray:2:29: expected '(', found ')'. Three numbers belong here: (x, y, z)");
  EXPECT_EQ(errorOf("trimesh { points = { } }"),
            "test.ray:2:20: expected '(' before points, found '{'. A list looks like (..., ...)");
  EXPECT_EQ(errorOf("trimesh { texture_uv = ((0,0,0)) }"),
            "test.ray:2:29: expected ')', found ','. Two numbers belong here: (u, v)");
  EXPECT_EQ(errorOf("trimesh { vertices = () }"),
            "test.ray:2:11: expected '}' or a keyword of \"trimesh\", found \"vertices\". It may "
            "hold material, name, points, faces, normals, materials, gennormals and texture_uv");
  EXPECT_EQ(errorOf("polymesh { normls = () }"),
            "test.ray:2:12: expected '}' or a keyword of \"polymesh\", found \"normls\". Did you "
            "mean \"normals\"?");
}

}  // namespace
}  // namespace planetree::test
