#include "bench/rivals/engines.hpp"
#include "bench/support/answer_check.hpp"
#include "bench/support/batches.hpp"

#include "bench_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>

namespace planetree::bench {
namespace {

EngineList allEngines() {
  EngineList all;
  for (const Rival& rival : rivals()) {
    if (!rival.engines)
      continue;
    for (auto& engine : rival.engines())
      all.push_back(std::move(engine));
    for (auto& engine : rival.enginesByName ? rival.enginesByName() : EngineList{})
      all.push_back(std::move(engine));
    for (auto& engine : rival.enginesForBatches ? rival.enginesForBatches() : EngineList{})
      all.push_back(std::move(engine));
  }
  return all;
}

std::vector<RaySet> raysOf(const BenchScene& scene) {
  return makeRaySets(scene.mesh, scene.camera, {kRayKinds.begin(), kRayKinds.end()},
                     {.pictureSize = 32, .randomCount = 1000});
}

TEST(Rivals, PlanetreeIsFirstAndAlwaysThere) {
  EXPECT_EQ(rivals().front().name, "planetree");
  ASSERT_NE(rivals().front().engines, nullptr);
  EXPECT_TRUE(rivals().front().joinsUnasked);
}

TEST(Rivals, EachLibraryHasOneDefaultAndModesOfDifferentNames) {
  for (const Rival& rival : rivals()) {
    if (!rival.engines)
      continue;
    std::set<std::string> modes;
    std::size_t defaults = 0;
    for (const auto& engine : rival.engines()) {
      EXPECT_EQ(engine->name(), rival.name);
      EXPECT_TRUE(modes.insert(engine->mode()).second) << engine->mode();
      defaults += engine->isDefault() ? 1u : 0u;
    }
    EXPECT_EQ(defaults, 1u) << rival.name;
  }
}

TEST(Rivals, Embree3HasThreeQualitiesFastAndRobust) {
  const Rival& embree = rivals()[1];
  ASSERT_EQ(embree.name, "embree3");
  if (!embree.engines)
    GTEST_SKIP() << embree.package << " was not found";
  std::set<std::string> modes;
  for (const auto& engine : embree.engines()) {
    modes.insert(engine->mode());
    EXPECT_EQ(engine->isDefault(), engine->mode() == "medium");
  }
  EXPECT_EQ(modes, (std::set<std::string>{"low", "medium", "high", "low-robust", "medium-robust",
                                          "high-robust"}));
}

TEST(Rivals, AllGiveTheAnswersOfBruteForce) {
  for (const BenchScene& scene : {test::ballScene(), makeScene("waves", test::waves())}) {
    for (const RaySet& set : raysOf(scene)) {
      for (const auto& engine : allEngines()) {
        const Answers truth = bruteForceAnswers(scene.mesh, set, 1, engine->precision());
        Answers answers = roomForAnswers(set);
        takeAnswers(*engine->build(scene.mesh, 2), set, 2, answers);
        const Disagreement found = compareAnswers(answers, truth, scene.diagonal);
        const std::size_t allowed = engine->isExact() ? 0 : set.rays.size() / 200;
        EXPECT_LE(found.wrong(), allowed)
            << engine->name() << " " << engine->mode() << ", " << rayKindName(set.kind);
        EXPECT_TRUE(!engine->isExact() || found.bitsDiffer == 0);
      }
    }
  }
}

TEST(Rivals, Embree3HasPacketsForBatchesFastAndRobust) {
  const Rival& embree = rivals()[1];
  if (!embree.engines)
    GTEST_SKIP() << embree.package << " was not found";
  std::set<std::string> modes;
  for (const auto& engine : embree.enginesForBatches()) {
    modes.insert(engine->mode());
    EXPECT_EQ(engine->name(), "embree3");
    EXPECT_FALSE(engine->isDefault());
    EXPECT_FALSE(engine->takesShapes());
  }
  EXPECT_EQ(modes, (std::set<std::string>{"medium-packets", "high-packets", "medium-robust-packets",
                                          "high-robust-packets"}));
}

Answers answersOfBatch(Batch& batch, const RaySet& set, unsigned threadCount) {
  Answers answers = roomForAnswers(set);
  batch.trace(threadCount);
  batch.readAnswers(answers);
  return answers;
}

TEST(Rivals, BatchesHaveTheAnswersOfSingleRays) {
  const BenchScene scene = makeScene("waves", test::waves());
  for (RaySet& set : raysOf(scene)) {
    // Not whole packets; and a picture whose tiles are cut off at its edges.
    set.rays.resize(set.rays.size() - 3);
    for (const std::size_t width : {set.pictureWidth, std::size_t{31}}) {
      set.pictureWidth = width;
      for (const auto& engine : allEngines()) {
        SCOPED_TRACE(engine->mode() + " " + std::string(rayKindName(set.kind)));
        const auto structure = engine->build(scene.mesh, 2);
        Answers single = roomForAnswers(set);
        takeAnswers(*structure, set, 1, single);
        const auto batch = allAtOnce(*structure, set);
        const Answers first = answersOfBatch(*batch, set, 2);
        const Disagreement found = compareAnswers(first, single, scene.diagonal);
        EXPECT_LE(found.wrong(), engine->isExact() ? 0 : set.rays.size() / 200);
        EXPECT_TRUE(!engine->isExact() || found.bitsDiffer == 0);
        batch->reset();
        EXPECT_EQ(answersOfBatch(*batch, set, 1), first) << "the second time";
      }
    }
  }
}

TEST(Rivals, ThoseThatTakeBatchesTakeThemOfAnySize) {
  const BenchScene scene = test::ballScene();
  for (const RaySet& set : raysOf(scene)) {
    for (const auto& engine : allEngines()) {
      if (!engine->takesBatches())
        continue;
      const auto structure = engine->build(scene.mesh, 1);
      const Answers single = answersOfBatch(*oneByOne(*structure, set), set, 1);
      for (const std::size_t callSize : {1u, 8u, 64u, 5000u})
        EXPECT_EQ(answersOfBatch(*structure->makeBatch(set, callSize), set, 1), single) << callSize;
    }
  }
}

TEST(Rivals, PlanetreeTakesBatches) {
  EXPECT_TRUE(planetreeEngines().front()->takesBatches());
}

TEST(Rivals, AllWriteWeightsNormalAndIds) {
  const BenchScene scene = test::ballScene();
  const Vec3f& eye = scene.camera.eye;
  const Rayf hitting = {.origin = eye, .direction = Vec3f(normalized(-Vec3d(eye)))};
  const Rayf missing = {.origin = eye, .direction = Vec3f(normalized(Vec3d(eye)))};
  const std::vector<Rayf> rays = {hitting, missing};
  for (const auto& engine : allEngines()) {
    SCOPED_TRACE(engine->name() + " " + engine->mode());
    const auto structure = engine->build(scene.mesh, 1);
    std::vector<Hitf> hits(2);
    structure->findIntersections(rays, hits);
    ASSERT_EQ(hits[0].geometry, 0u);
    ASSERT_LT(hits[0].primitive, scene.mesh.faces.size());
    const auto [a, b, c] = scene.mesh.view().corners(hits[0].primitive);
    const Vec3f byWeights = a * (1.0f - hits[0].u - hits[0].v) + b * hits[0].u + c * hits[0].v;
    EXPECT_NEAR(length(byWeights - hitting.at(hits[0].t)), 0.0f, 1e-4f);
    const Vec3f normal = normalized(cross(b - a, c - a));
    EXPECT_NEAR(std::fabs(dot(normalized(hits[0].normal), normal)), 1.0f, 1e-4f);
    EXPECT_EQ(hits[1], Hitf{});
  }
}

TEST(Rivals, AllHonourTheEndOfAnyHitRays) {
  const BenchScene scene = test::ballScene();
  const Vec3f& eye = scene.camera.eye;
  const float distance = static_cast<float>(length(Vec3d(eye)));
  std::vector<Rayf> rays(3, {.origin = eye, .direction = Vec3f(normalized(-Vec3d(eye)))});
  rays[0].tMax = distance - 1.5f;  // ends before the ball
  rays[1].tMax = distance;         // in its middle
  for (const auto& engine : allEngines()) {
    std::vector<std::uint8_t> occluded(3, 7);
    engine->build(scene.mesh, 1)->findOcclusions(rays, occluded);
    EXPECT_EQ(occluded, (std::vector<std::uint8_t>{0, 1, 1}))
        << engine->name() << " " << engine->mode();
  }
}

TEST(Rivals, ThoseThatSayTheyDoNotReadTheMeshAnswerWithoutIt) {
  const BenchScene scene = makeScene("waves", test::waves());
  const RaySet set = raysOf(scene).front();
  for (const auto& engine : allEngines()) {
    if (engine->queriesReadMesh())
      continue;
    TriangleMesh<float> mesh = scene.mesh;
    mesh.positions.reserve(mesh.positions.size() + 1);
    const auto structure = engine->build(mesh, 1);
    Answers before = roomForAnswers(set);
    takeAnswers(*structure, set, 1, before);
    std::fill(mesh.positions.begin(), mesh.positions.end(), Vec3f{});
    std::fill(mesh.faces.begin(), mesh.faces.end(), FaceIndices{});
    Answers after = roomForAnswers(set);
    takeAnswers(*structure, set, 1, after);
    EXPECT_EQ(before, after) << engine->name() << " " << engine->mode();
  }
}

}  // namespace
}  // namespace planetree::bench
