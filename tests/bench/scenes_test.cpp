#include "bench/scene/generated_scenes.hpp"
#include "bench/scene/write_ply.hpp"
#include "bench/support/answer_check.hpp"
#include "render/camera.hpp"

#include "bench_meshes.hpp"

#include <planetree/mesh/read_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

const NamedScene kScenes[] = {{"terrain", [] { return makeTerrain(); }, 2'000'000, 2'200'000},
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
  const render::PinholeCamera camera(scene.camera, 1.0);
  RaySet set;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x)
      set.rays.push_back(camera.ray((x + 0.5) / 8.0, (y + 0.5) / 8.0));
  }
  for (const Hitf& hit : bruteForceAnswers(scene.mesh, set, 2).hits)
    EXPECT_NE(hit.primitive, kNoId);
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
