#include "bench/scene/shape_scenes.hpp"

#include "bench/rivals/engines.hpp"
#include "bench/support/answer_check.hpp"
#include "bench/support/measure.hpp"

#include "broken_engines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

namespace planetree::bench {
namespace {

/// Small scenes of both kinds, looked at from outside.
BenchScene smallSpheres() {
  BenchScene scene;
  scene.name = "spheres";
  scene.spheres = makeSpheres(600);
  frameScene(scene, boxCorners(scene));
  return scene;
}
BenchScene smallShapes() {
  BenchScene scene;
  scene.name = "shapes";
  scene.shapes = makeMixedShapes(600);
  frameScene(scene, boxCorners(scene));
  return scene;
}

std::vector<RaySet> raysOf(const BenchScene& scene) {
  return makeRaySets(scene.objects(), scene.camera, {kRayKinds.begin(), kRayKinds.end()},
                     {.pictureSize = 48, .randomCount = 2000});
}

EngineList enginesForShapes() {
  EngineList all;
  for (const Rival& rival : rivals()) {
    if (!rival.engines)
      continue;
    for (auto& engine : rival.engines()) {
      if (engine->takesShapes())
        all.push_back(std::move(engine));
    }
  }
  return all;
}

TEST(ShapeScenes, HoldOneShapeForEachUnitOfVolume) {
  for (const BenchScene& scene : {smallSpheres(), smallShapes()}) {
    EXPECT_EQ(scene.objects().size(), 600u);
    EXPECT_EQ(scene.objects().mesh(), nullptr);
    Box3 bounds;
    for (const Vec3f& corner : boxCorners(scene))
      bounds.extend(corner);
    for (const Axis axis : kAxes)
      EXPECT_NEAR(bounds.size()[axis], std::cbrt(600.0), 1.5) << scene.name;
  }
}

TEST(ShapeScenes, AreTheSameEachTime) {
  EXPECT_EQ(makeSpheres(1000), makeSpheres(1000));
  const auto first = makeMixedShapes(500);
  const auto second = makeMixedShapes(500);
  for (std::size_t i = 0; i < first.size(); ++i)
    ASSERT_EQ(first[i]->bounds(), second[i]->bounds()) << i;
}

TEST(ShapeScenes, MixFiveKindsOfShapes) {
  std::set<std::string> kinds;
  for (const VirtualShape& shape : makeMixedShapes(50)) {
    const Geometry<float>& geometry = *shape;
    kinds.insert(typeid(geometry).name());
  }
  EXPECT_EQ(kinds.size(), 5u);
}

TEST(ShapeScenes, AllEnginesGiveTheAnswersOfBruteForce) {
  for (const BenchScene& scene : {smallSpheres(), smallShapes()}) {
    for (const RaySet& set : raysOf(scene)) {
      const Answers truth = bruteForceAnswers(scene.objects(), set, 2);
      for (const auto& engine : enginesForShapes()) {
        SCOPED_TRACE(scene.name + ", " + std::string(rayKindName(set.kind)) + ", " +
                     engine->name() + " " + engine->mode());
        Answers answers = roomForAnswers(set);
        takeAnswers(*engine->build(scene.objects(), 2), set, 2, answers);
        const Disagreement found = compareAnswers(answers, truth, scene.diagonal);
        EXPECT_LE(found.wrong(), engine->isExact() ? 0 : set.rays.size() / 200);
        EXPECT_TRUE(!engine->isExact() || found.bitsDiffer == 0);
      }
    }
  }
}

TEST(ShapeScenes, RaysOfAllKindsHitAndMiss) {
  for (const BenchScene& scene : {smallSpheres(), smallShapes()}) {
    for (const RaySet& set : raysOf(scene)) {
      const Answers truth = bruteForceAnswers(scene.objects(), set, 2);
      const std::size_t hitCount =
          static_cast<std::size_t>(
              std::count_if(truth.hits.begin(), truth.hits.end(),
                            [](const Hitf& hit) { return hit.primitive != kNoId; })) +
          static_cast<std::size_t>(
              std::count(truth.occluded.begin(), truth.occluded.end(), std::uint8_t{1}));
      EXPECT_GT(hitCount, set.rays.size() / 20) << scene.name << " " << rayKindName(set.kind);
      EXPECT_LT(hitCount, set.rays.size()) << scene.name << " " << rayKindName(set.kind);
    }
  }
}

TEST(ShapeScenes, AnEngineThatLiesAboutShapesIsNotTimed) {
  MeasureSettings settings;
  settings.repetitions = 1;
  settings.counts = {.pictureSize = 48, .randomCount = 2000};
  const test::Lie lie = {.aboutHit = [](std::size_t, Hitf& hit) { hit = {}; },
                         .aboutOcclusion = [](std::size_t, std::uint8_t&) {}};
  EXPECT_THROW((void)measureRays(smallShapes(), test::besideBroken(lie), settings), WrongAnswers);
  EXPECT_EQ(measureRays(smallShapes(), test::besideBroken({}), settings).size(), 8u);
}

TEST(ShapeScenes, CgalTakesNone) {
  for (const Rival& rival : rivals()) {
    if (!rival.engines)
      continue;
    for (const auto& engine : rival.engines())
      EXPECT_EQ(engine->takesShapes(), rival.name != "cgal") << engine->mode();
  }
}

}  // namespace
}  // namespace planetree::bench
