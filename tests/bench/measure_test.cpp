#include "bench/support/measure.hpp"

#include "bench/support/counted_heap.hpp"

#include "bench_meshes.hpp"
#include "broken_engines.hpp"

#include <planetree/build_tree.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace planetree::bench {
namespace {

struct Recorded {
  MeasureSettings settings;
  std::vector<std::string> said;

  Recorded() {
    settings.repetitions = 2;
    settings.counts = {.pictureSize = 64, .randomCount = 4096};
    settings.bruteForceTests = 200'000;
    settings.say = [this](const std::string& line) { said.push_back(line); };
  }
  [[nodiscard]] bool hasSaid(const std::string& text) const {
    return std::any_of(said.begin(), said.end(), [&](const std::string& line) {
      return line.find(text) != std::string::npos;
    });
  }
};

using Measure = std::vector<Result> (*)(const BenchScene&, const EngineList&,
                                        const MeasureSettings&);

test::Lie missesEveryTenth() {
  return {.aboutHit =
              [](std::size_t ray, Hitf& hit) {
                if (ray % 10 == 0)
                  hit = {};
              },
          .aboutOcclusion = [](std::size_t, std::uint8_t&) {}};
}

TEST(Measure, RefusesAnEngineThatLiesBeforeItIsTimed) {
  for (const Measure measure :
       {Measure(&measureRays), Measure(&measureBatches), Measure(&measureBuild)}) {
    Recorded run;
    const EngineList engines = test::besideBroken(missesEveryTenth());
    EXPECT_THROW((void)measure(test::ballScene(), engines, run.settings), WrongAnswers);
    EXPECT_TRUE(run.hasSaid("broken liar against brute force"));
    EXPECT_TRUE(run.hasSaid("WRONG"));
    const auto& counts = dynamic_cast<const test::BrokenEngine&>(*engines.back()).counts();
    EXPECT_EQ(counts.builds, 1u) << "it was built again, to be timed";
  }
}

TEST(Measure, RefusesAnEngineThatLiesBeforeItsMemoryIsCounted) {
  if (!heapIsCounted())
    GTEST_SKIP() << "this build does not count memory";
  Recorded run;
  EXPECT_THROW(
      (void)measureMemory(test::ballScene(), test::besideBroken(missesEveryTenth()), run.settings),
      WrongAnswers);
}

TEST(Measure, RefusesAnEngineThatLiesBeforeItsPeakIsCounted) {
  if (!heapIsCounted())
    GTEST_SKIP() << "this build does not count memory";
  Recorded run;
  EXPECT_THROW(
      (void)measurePeak(test::ballScene(), test::besideBroken(missesEveryTenth()), run.settings),
      WrongAnswers);
}

TEST(Measure, RefusesALieAboutOcclusionAlone) {
  Recorded run;
  const test::Lie lie = {.aboutHit = [](std::size_t, Hitf&) {},
                         .aboutOcclusion = [](std::size_t, std::uint8_t& o) { o = 0; }};
  // The hollow side of the waves: on a ball no occlusion ray hits.
  const BenchScene scene = makeScene("waves", test::waves());
  EXPECT_THROW((void)measureRays(scene, test::besideBroken(lie), run.settings), WrongAnswers);
  EXPECT_TRUE(run.hasSaid("waves ao: broken liar"));
  EXPECT_FALSE(run.hasSaid("waves primary: broken liar"));
}

TEST(Measure, TellsDisagreementsThatItAccepts) {
  Recorded run;
  const test::Lie lie = {.aboutHit =
                             [](std::size_t ray, Hitf& hit) {
                               if (ray == 2080 && hit.primitive != kNoId)
                                 hit.primitive ^= 1u;
                             },
                         .aboutOcclusion = [](std::size_t, std::uint8_t&) {}};
  run.settings.kinds = {RayKind::Primary};
  EXPECT_EQ(measureRays(test::ballScene(), test::besideBroken(lie), run.settings).size(), 2u);
  EXPECT_TRUE(run.hasSaid("1 of another object at the same distance"));
}

TEST(Measure, AnEngineThatClaimsToBeExactMustHaveEveryBit) {
  Recorded run;
  const test::Lie lie = {
      .aboutHit = [](std::size_t, Hitf& hit) { hit.t = std::nextafter(hit.t, 0.0f); },
      .aboutOcclusion = [](std::size_t, std::uint8_t&) {}};
  EXPECT_THROW((void)measureRays(test::ballScene(), test::besideBroken(lie, true), run.settings),
               WrongAnswers);
  EXPECT_NO_THROW(
      (void)measureRays(test::ballScene(), test::besideBroken(lie, false), run.settings));
}

TEST(Measure, GivesEachEngineOneResultForEachKindOfRays) {
  Recorded run;
  run.settings.threadCount = 2;
  const auto results =
      measureRays(makeScene("waves", test::waves()), planetreeEngines(), run.settings);
  ASSERT_EQ(results.size(), 4u);
  std::set<std::string> kinds;
  for (const Result& result : results) {
    kinds.insert(result.kind);
    EXPECT_EQ(result.scene, "waves");
    EXPECT_EQ(result.measure, "mrays_per_second");
    EXPECT_EQ(result.engine, "planetree");
    EXPECT_EQ(result.mode, "balanced-watertight");
    EXPECT_TRUE(result.isDefault);
    EXPECT_EQ(result.threadCount, 2u);
    EXPECT_GT(result.value, 0.0);
    EXPECT_FALSE(result.commit.empty());
    EXPECT_NE(result.compiler.find("++ "), std::string::npos) << result.compiler;
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"ao", "diffuse", "primary", "random"}));
}

TEST(Measure, TimesAsManyBuildsAsRepetitions) {
  Recorded run;
  const EngineList engines = test::besideBroken({});
  const auto results = measureBuild(test::ballScene(), engines, run.settings);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[1].measure, "build_seconds");
  EXPECT_EQ(results[1].kind, "");
  EXPECT_GT(results[1].value, 0.0);
  const auto& counts = dynamic_cast<const test::BrokenEngine&>(*engines.back()).counts();
  EXPECT_EQ(counts.builds, 1u + run.settings.repetitions);
}

TEST(Measure, CountsTheMeshOnlyWhereQueriesReadIt) {
  if (!heapIsCounted())
    GTEST_SKIP() << "this build does not count memory";
  Recorded run;
  // The broken engine holds the same tree, and says that it does not read the mesh.
  const BenchScene scene = test::ballScene();
  const auto results = measureMemory(scene, test::besideBroken({}), run.settings);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].measure, "bytes_per_triangle");
  const double meshBytes =
      static_cast<double>(scene.mesh.positions.size() * 12 + scene.mesh.faces.size() * 12);
  const auto triangles = static_cast<double>(scene.mesh.faces.size());
  EXPECT_NEAR(results[0].value - results[1].value, meshBytes / triangles, 1.0);
  EXPECT_GT(results[1].value, 4.0) << "less than one reference for each triangle";
}

TEST(Measure, ThePeakIsWhatTheBuildHeldAtLeast) {
  if (!heapIsCounted())
    GTEST_SKIP() << "this build does not count memory";
  Recorded run;
  const BenchScene scene = makeScene("waves", test::waves());
  // The broken engine says that it does not read the mesh, which the peak has nothing to do with.
  const EngineList engines = test::besideBroken({});
  const auto held = measureMemory(scene, engines, run.settings);
  const auto peaks = measurePeak(scene, engines, run.settings);
  ASSERT_EQ(peaks.size(), 2u);
  EXPECT_EQ(peaks[0].measure, "peak_bytes_per_triangle");
  EXPECT_EQ(peaks[0].kind, "");
  EXPECT_EQ(peaks[0].objectCount, scene.mesh.faces.size());
  EXPECT_GT(peaks[1].value, held[1].value);
  const double onePage = 4096.0 / static_cast<double>(scene.mesh.faces.size());
  EXPECT_NEAR(peaks[0].value, peaks[1].value, onePage);
}

TEST(Measure, ThePeakIsAboutWhatTheLibraryItselfReports) {
  if (!heapIsCounted())
    GTEST_SKIP() << "this build does not count memory";
  Recorded run;
  TriangleMesh<float> mesh;
  addSurface(mesh, 200, 200, [](double u, double v) { return Vec3d{u, std::sin(9.0 * u * v), v}; });
  const BenchScene scene = makeScene("surface", std::move(mesh));
  const auto tree = buildTree(scene.mesh.view(), BuildOptions{.threadCount = 1});
  const double reported =
      static_cast<double>(tree.report().peakBytes) / static_cast<double>(scene.mesh.faces.size());
  const auto peaks = measurePeak(scene, planetreeEngines(), run.settings);
  // The library does not count small things, such as the room of a few megabytes that each thread
  // uses again and again.
  const double room = 4e6 / static_cast<double>(scene.mesh.faces.size());
  EXPECT_GT(peaks.front().value, 0.9 * reported);
  EXPECT_LT(peaks.front().value, 1.1 * reported + room);
}

TEST(Measure, CountsTheStepsOfThoseThatCount) {
  Recorded run;
  // The broken engine does not count.
  const BenchScene scene = test::ballScene();
  const auto results = measureSteps(scene, test::besideBroken({}), run.settings);
  // Nothing occludes anything outside of a ball, but the rays are there.
  ASSERT_EQ(results.size(), 8u);
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(results[i].engine, "planetree");
    EXPECT_EQ(results[i].measure, i % 2 == 0 ? "node_steps_per_ray" : "block_steps_per_ray");
    EXPECT_EQ(results[i].kind, rayKindName(kRayKinds[i / 2]));
    EXPECT_GT(results[i].value, 0.0);
    EXPECT_LT(results[i].value, static_cast<double>(scene.mesh.faces.size()));
  }
}

TEST(Measure, StepsAreAtLeastTheRootAndAtMostAll) {
  Recorded run;
  run.settings.kinds = {RayKind::Random};
  const BenchScene scene = makeScene("waves", test::waves());
  const auto results = measureSteps(scene, planetreeEngines(), run.settings);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_GT(results[0].value, 0.5);
  EXPECT_GT(results[1].value, 0.01);
  // A block holds eight triangles and more, and a node at least two of them.
  const auto faceCount = static_cast<double>(scene.mesh.faces.size());
  EXPECT_LT(results[0].value, faceCount / 8.0);
  EXPECT_LT(results[1].value, faceCount / 8.0);
}

TEST(Measure, BatchesAreAMeasureOfTheirOwn) {
  Recorded run;
  run.settings.threadCount = 2;
  const auto results =
      measureBatches(makeScene("waves", test::waves()), test::besideBroken({}), run.settings);
  ASSERT_EQ(results.size(), 8u) << "who has no batches is asked ray by ray";
  for (const Result& result : results) {
    EXPECT_EQ(result.measure, "batch_mrays_per_second");
    EXPECT_EQ(result.threadCount, 2u);
    EXPECT_GT(result.value, 0.0);
  }
}

TEST(Measure, SmallBatchesStandBesideTheirRaysOneByOne) {
  Recorded run;
  run.settings.kinds = {RayKind::Random};
  run.settings.threadCount = 2;
  // The broken engine takes no batches.
  const auto results = measureSmallBatches(test::ballScene(), test::besideBroken({}), run.settings);
  std::vector<std::string> measures;
  for (const Result& result : results) {
    measures.push_back(result.measure);
    EXPECT_EQ(result.engine, "planetree");
    EXPECT_EQ(result.kind, "random");
    EXPECT_EQ(result.threadCount, 1u) << "whatever the others use";
    EXPECT_GT(result.value, 0.0);
    EXPECT_TRUE(isOfSmallBatches(result.measure));
  }
  EXPECT_EQ(measures, (std::vector<std::string>{
                          "nanoseconds_one_by_one", "nanoseconds_of_a_batch_of_1",
                          "nanoseconds_of_a_batch_of_8", "nanoseconds_of_a_batch_of_64"}));
}

TEST(Measure, SaysWhyAKindHasNoRays) {
  Recorded run;
  run.settings.kinds = {RayKind::Diffuse};
  BenchScene scene = test::ballScene();
  scene.camera.at = scene.camera.eye + (scene.camera.eye - scene.camera.at);
  EXPECT_TRUE(measureRays(scene, planetreeEngines(), run.settings).empty());
  EXPECT_TRUE(run.hasSaid("no diffuse rays"));
}

}  // namespace
}  // namespace planetree::bench
