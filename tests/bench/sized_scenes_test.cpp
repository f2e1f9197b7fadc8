#include "bench/scene/sized_scenes.hpp"

#include "bench/scene/generated_scenes.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/geometry/box3.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace planetree::bench {
namespace {

TEST(SizedSceneName, HasAFamilyAndANumberOfTriangles) {
  const auto size = [](const char* name) {
    const auto found = sizedSceneName(name);
    return found ? found->triangles : 0;
  };
  EXPECT_EQ(size("terrain-10k"), 10'000u);
  EXPECT_EQ(size("scatter-4m"), 4'000'000u);
  EXPECT_EQ(size("scatter-1234"), 1'234u);
  EXPECT_EQ(sizedSceneName("scatter-4m")->family, "scatter");
  for (const char* other :
       {"", "terrain", "terrain-", "terrain-k", "terrain-10g", "terrain-10kk", "terrain-10k.ply",
        "terrain-999", "terrain-101m", "terrain-99999999999999999999", "terrain--10k",
        "foliage-10k", "folder/terrain-10k", "bunny.ply", "Terrain-10k"})
    EXPECT_FALSE(sizedSceneName(other)) << other;
}

TEST(SizedScenes, HaveAboutAsManyTrianglesAsAskedFor) {
  for (const std::uint64_t triangles : {1'000u, 10'000u, 300'000u}) {
    const auto count = static_cast<double>(triangles);
    EXPECT_NEAR(static_cast<double>(makeSizedTerrain(triangles).faces.size()), count, 0.05 * count);
    const std::size_t scattered = makeScatter(triangles).faces.size();
    EXPECT_GE(scattered, triangles);
    EXPECT_LT(scattered, triangles + 250);
  }
}

TEST(SizedScenes, HoldOnlyTrianglesThatCanBeHit) {
  for (const TriangleMesh<float>& mesh : {makeSizedTerrain(20'000), makeScatter(20'000)})
    EXPECT_EQ(buildTree(mesh.view()).report().skippedCount, 0u);
}

TEST(SizedScenes, AreTheSameEachTime) {
  const TriangleMesh<float> first = makeScatter(5'000);
  const TriangleMesh<float> second = makeScatter(5'000);
  EXPECT_EQ(first.positions, second.positions);
  EXPECT_EQ(first.faces, second.faces);
}

TEST(SizedScenes, TerrainOfTwoMillionIsTheOneThatFilesHave) {
  const TriangleMesh<float> mesh = makeSizedTerrain(2'097'152);
  EXPECT_TRUE(mesh.positions == makeTerrain().positions);
}

TEST(SizedScenes, ScatterLiesInItsCubeAndIsClustered) {
  const TriangleMesh<float> mesh = makeScatter(200'000);
  constexpr std::size_t kCells = 8;
  std::vector<std::size_t> counts(kCells * kCells * kCells, 0);
  for (const Vec3f& position : mesh.positions) {
    std::size_t cell = 0;
    for (const Axis axis : kAxes) {
      EXPECT_GT(position[axis], -20.0f);
      EXPECT_LT(position[axis], 120.0f);
      const float inCube = std::clamp(position[axis] / 100.0f, 0.0f, 0.999f);
      cell = cell * kCells + static_cast<std::size_t>(inCube * kCells);
    }
    ++counts[cell];
  }
  std::sort(counts.begin(), counts.end());
  EXPECT_EQ(counts.front(), 0u) << "there is empty space";
  EXPECT_GT(counts.back(), 8 * mesh.positions.size() / counts.size());
}

TEST(SizedScenes, AreSeenFromOutside) {
  const BenchScene scene = makeSizedScene({"scatter", 2'000}, "scatter-2k");
  EXPECT_EQ(scene.name, "scatter-2k");
  EXPECT_GT(scene.diagonal, 10.0);
  EXPECT_GE(scene.objects().size(), 2'000u);
}

}  // namespace
}  // namespace planetree::bench
