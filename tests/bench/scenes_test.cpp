#include "bench/scene/generated_scenes.hpp"
#include "bench/scene/write_ply.hpp"
#include "bench/support/ray_kinds.hpp"

#include "bench_meshes.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/mesh/read_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>

namespace planetree::bench {
namespace {

struct NamedScene {
  const char* name;
  TriangleMesh<float> (*make)();
  std::size_t least;  ///< triangles
  std::size_t most;
};

const NamedScene kScenes[] = {{"terrain", &makeTerrain, 2'000'000, 2'200'000},
                              {"foliage", &makeFoliage, 500'000, 800'000},
                              {"interior", &makeInterior, 300'000, 800'000}};

TEST(GeneratedScenes, AreFiniteWholeAndOfTheSizeTheyClaim) {
  for (const NamedScene& scene : kScenes) {
    const TriangleMesh<float> mesh = scene.make();
    EXPECT_GE(mesh.faces.size(), scene.least) << scene.name;
    EXPECT_LE(mesh.faces.size(), scene.most) << scene.name;
    EXPECT_TRUE(std::all_of(mesh.positions.begin(), mesh.positions.end(),
                            [](const Vec3f& position) { return isFinite(position); }))
        << scene.name;
    EXPECT_TRUE(std::all_of(mesh.faces.begin(), mesh.faces.end(), [&](const FaceIndices& face) {
      return *std::max_element(face.begin(), face.end()) < mesh.positions.size();
    })) << scene.name;
  }
}

TEST(GeneratedScenes, AreTheSameEachTime) {
  const TriangleMesh<float> first = makeFoliage();
  const TriangleMesh<float> second = makeFoliage();
  EXPECT_EQ(first.positions, second.positions);
  EXPECT_EQ(first.faces, second.faces);
}

TEST(GeneratedScenes, TheInteriorIsSeenFromInside) {
  const BenchScene scene = makeScene("generated_interior", makeInterior());
  const auto sets = makeRaySets(scene.mesh, scene.camera, {RayKind::Primary},
                                {.pictureSize = 32, .randomCount = 0});
  const auto tree = buildTree(scene.mesh.view());
  for (const Rayf& ray : sets.front().rays)
    ASSERT_TRUE(tree.isOccluded(ray));
}

TEST(WritePly, IsReadBackAsItWas) {
  const TriangleMesh<float> mesh = test::ball();
  const std::string bytes = plyBytes(mesh);
  const auto read = readMesh<float>(std::as_bytes(std::span(bytes)), "ball.ply");
  EXPECT_EQ(read.positions, mesh.positions);
  EXPECT_EQ(read.faces, mesh.faces);
}

TEST(SceneName, IsTheFileNameWithoutFolderAndExtension) {
  EXPECT_EQ(sceneName("some/folder/bunny.ply"), "bunny");
  EXPECT_EQ(sceneName("conference_clean.obj"), "conference_clean");
}

TEST(MakeScene, LeavesSixteenBytesToReadFromTheLastPosition) {
  const BenchScene scene = test::ballScene();
  EXPECT_GT(scene.mesh.positions.capacity(), scene.mesh.positions.size());
  EXPECT_NEAR(scene.diagonal, std::sqrt(12.0), 1e-6);
}

}  // namespace
}  // namespace planetree::bench
