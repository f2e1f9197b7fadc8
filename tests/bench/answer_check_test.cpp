#include "bench/support/answer_check.hpp"

#include "bench_meshes.hpp"
#include "broken_engines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace planetree::bench {
namespace {

constexpr double kDiagonal = 10.0;

Answers answer(const Hitf& hit) {
  return {.hits = {hit}, .occluded = {}};
}

const Hitf kHit = {.t = 4.0f, .u = 0.25f, .v = 0.5f, .normal = {}, .geometry = 0, .primitive = 7};

TEST(CompareAnswers, TellsEachWayToDiffer) {
  Hitf farther = kHit;
  farther.t = 4.01f;
  Hitf nearly = kHit;
  nearly.t = std::nextafter(4.0f, 5.0f);
  Hitf neighbour = kHit;
  neighbour.primitive = 8;
  EXPECT_EQ(compareAnswers(answer(kHit), answer(kHit), kDiagonal).bitsDiffer, 0u);
  EXPECT_EQ(compareAnswers(answer({}), answer(kHit), kDiagonal).missed, 1u);
  EXPECT_EQ(compareAnswers(answer(kHit), answer({}), kDiagonal).invented, 1u);
  EXPECT_EQ(compareAnswers(answer(farther), answer(kHit), kDiagonal).otherDistance, 1u);
  EXPECT_EQ(compareAnswers(answer(neighbour), answer(kHit), kDiagonal).otherId, 1u);
  EXPECT_EQ(compareAnswers(answer(neighbour), answer(kHit), kDiagonal).wrong(), 0u);
  EXPECT_EQ(compareAnswers(answer(nearly), answer(kHit), kDiagonal).wrong(), 0u);
  EXPECT_EQ(compareAnswers(answer(nearly), answer(kHit), kDiagonal).bitsDiffer, 1u);
}

TEST(CompareAnswers, TakesNoNaNForADistance) {
  Hitf nan = kHit;
  nan.t = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(compareAnswers(answer(nan), answer(kHit), kDiagonal).otherDistance, 1u);
}

TEST(CompareAnswers, TellsMissedFromInventedOcclusions) {
  const Answers said = {.hits = {}, .occluded = {0, 1, 1, 0}};
  const Answers truth = {.hits = {}, .occluded = {1, 0, 1, 0}};
  const Disagreement found = compareAnswers(said, truth, kDiagonal);
  EXPECT_EQ(found.rayCount, 4u);
  EXPECT_EQ(found.missed, 1u);
  EXPECT_EQ(found.invented, 1u);
  EXPECT_EQ(found.bitsDiffer, 2u);
}

struct CheckedBall {
  BenchScene scene = test::ballScene();
  RaySet set = makeRaySets(scene.mesh, scene.camera, {RayKind::Primary},
                           {.pictureSize = 64, .randomCount = 0})
                   .front();

  [[nodiscard]] CheckedAnswers honest(bool isExact) const {
    CheckedAnswers checked{"honest", "mode", isExact, Precision::Float, roomForAnswers(set)};
    takeAnswers(*planetreeEngines().front()->build(scene.mesh, 1), set, 1, checked.answers);
    return checked;
  }
  [[nodiscard]] std::vector<CheckedPair> check(const std::vector<CheckedAnswers>& all) const {
    return checkAnswers(scene.mesh, set, all, scene.diagonal, 300, 2);
  }
};

bool areAcceptable(const std::vector<CheckedPair>& pairs) {
  return std::all_of(pairs.begin(), pairs.end(),
                     [](const CheckedPair& pair) { return pair.isAcceptable; });
}

TEST(CheckAnswers, AcceptsHonestEngines) {
  const CheckedBall ball;
  const auto pairs = ball.check({ball.honest(true), ball.honest(true), ball.honest(false)});
  EXPECT_EQ(pairs.size(), 5u);
  EXPECT_TRUE(areAcceptable(pairs));
}

TEST(CheckAnswers, AsksBruteForceWhereAllEnginesTellTheSameLie) {
  const CheckedBall ball;
  CheckedAnswers liar = ball.honest(false);
  for (Hitf& hit : liar.answers.hits)
    hit.t *= 1.5f;
  const auto pairs = ball.check({liar, liar});
  EXPECT_EQ(pairs[0].reference, "brute force");
  EXPECT_FALSE(pairs[0].isAcceptable);
  EXPECT_FALSE(pairs[1].isAcceptable);
  EXPECT_EQ(pairs[2].reference, "honest mode");
  EXPECT_TRUE(pairs[2].isAcceptable);
}

TEST(CheckAnswers, FindsARareLieAmongAllRaysWhereTheSampleMayMissIt) {
  const CheckedBall ball;
  CheckedAnswers liar = ball.honest(false);
  std::size_t lies = 0;
  for (std::size_t i = 0; i < liar.answers.hits.size(); i += 97, ++lies)
    liar.answers.hits[i] = {.t = 1.0f, .geometry = 0, .primitive = 0};
  const auto pairs = ball.check({ball.honest(true), liar});
  EXPECT_FALSE(areAcceptable(pairs));
  EXPECT_GE(pairs.back().disagreement.wrong(), lies / 2);
}

TEST(CheckAnswers, OneWrongRayIsAllowedUnlessTheEngineIsExact) {
  const CheckedBall ball;
  const std::vector<std::size_t> sample = sampleOf(ball.set, 300);
  for (const bool isExact : {false, true}) {
    CheckedAnswers liar = ball.honest(isExact);
    liar.answers.hits[sample[100]].t = 0.5f;
    liar.answers.hits[sample[100]].primitive = 0;
    EXPECT_EQ(areAcceptable(ball.check({ball.honest(true), liar})), !isExact);
  }
}

TEST(CheckAnswers, AsksBruteForceInThePrecisionOfTheEngine) {
  const CheckedBall ball;
  CheckedAnswers inDouble = ball.honest(true);
  inDouble.precision = Precision::Double;
  EXPECT_FALSE(ball.check({inDouble})[0].isAcceptable) << "its hits are those of floats";
  inDouble.answers = bruteForceAnswers(ball.scene.mesh, ball.set, 2, Precision::Double);
  EXPECT_TRUE(areAcceptable(ball.check({inDouble, ball.honest(true)})));
}

TEST(BruteForce, IsTheSameOnAnyNumberOfThreads) {
  const CheckedBall ball;
  const Answers one = bruteForceAnswers(ball.scene.mesh, ball.set, 1);
  EXPECT_EQ(one, bruteForceAnswers(ball.scene.mesh, ball.set, 3));
  EXPECT_EQ(compareAnswers(ball.honest(true).answers, one, ball.scene.diagonal).bitsDiffer, 0u);
}

TEST(BruteForce, PassesOverFacesThatCannotBeHit) {
  TriangleMesh<float> mesh = test::ball();
  const auto faces = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.faces.push_back({0, 1, faces + 5});
  mesh.positions.push_back({std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f});
  mesh.faces.push_back({0, 1, faces});
  const CheckedBall ball;
  EXPECT_EQ(bruteForceAnswers(mesh, ball.set, 1), bruteForceAnswers(test::ball(), ball.set, 1));
}

TEST(SampleOf, ChoosesTheSameRaysEachTimeAndAllOfASmallSet) {
  RaySet set;
  set.rays.resize(1000);
  const auto sample = sampleOf(set, 100);
  EXPECT_EQ(sample.size(), 100u);
  EXPECT_EQ(sample, sampleOf(set, 100));
  EXPECT_TRUE(std::is_sorted(sample.begin(), sample.end()));
  EXPECT_GT(sample.back(), 900u);
  EXPECT_LT(sample.front(), 100u);
  EXPECT_EQ(std::set<std::size_t>(sample.begin(), sample.end()).size(), 100u);
  EXPECT_EQ(sampleOf(set, 5000).size(), 1000u);
  EXPECT_TRUE(sampleOf({}, 10).empty());
}

}  // namespace
}  // namespace planetree::bench
