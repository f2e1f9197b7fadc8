#include "exact/exact_judge.hpp"

#include <planetree/planetree.hpp>

#include "exact/judged_answers.hpp"
#include "soak/closed_solids.hpp"
#include "soak/solid_rays.hpp"
#include "support/hard_cases.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace planetree::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();
const Corners kTriangle = {Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}};

Rayd down(double x, double y, double tMin = 0.0, double tMax = kInfinity) {
  return {{x, y, 2.0}, {0.0, 0.0, -1.0}, tMin, tMax};
}

TEST(Meet, TellsTheInsideFromTheOutlineAndTheOutside) {
  EXPECT_EQ(meet(down(0.25, 0.25), kTriangle).kind, Meeting::Hit);
  EXPECT_EQ(meet(down(0.5, 0.5), kTriangle).kind, Meeting::Touching);
  EXPECT_EQ(meet(down(0.0, 0.0), kTriangle).kind, Meeting::Touching);
  EXPECT_EQ(meet(down(1.0, 1.0), kTriangle).kind, Meeting::Miss);
  // A denormal aside, which no rounded sum would notice.
  EXPECT_EQ(meet(down(kTiny, 0.25), kTriangle).kind, Meeting::Hit);
  EXPECT_EQ(meet(down(-kTiny, 0.25), kTriangle).kind, Meeting::Miss);
  EXPECT_EQ(meet(down(0.0, 0.25), kTriangle).kind, Meeting::Touching);
}

TEST(Meet, TellsAnEndOfTheIntervalFromItsInside) {
  const double justBefore = std::nextafter(2.0, 0.0);
  const double justBehind = std::nextafter(2.0, 3.0);
  EXPECT_EQ(meet(down(0.25, 0.25, 0.0, justBehind), kTriangle).kind, Meeting::Hit);
  EXPECT_EQ(meet(down(0.25, 0.25, 0.0, 2.0), kTriangle).kind, Meeting::Touching);
  EXPECT_EQ(meet(down(0.25, 0.25, 0.0, justBefore), kTriangle).kind, Meeting::Miss);
  EXPECT_EQ(meet(down(0.25, 0.25, 2.0), kTriangle).kind, Meeting::Touching);
  EXPECT_EQ(meet(down(0.25, 0.25, justBehind), kTriangle).kind, Meeting::Miss);
  EXPECT_EQ(meet(down(0.25, 0.25, -kInfinity), kTriangle).kind, Meeting::Hit);
}

TEST(Meet, GivesTheIntervalOfT) {
  const ExactMeeting through = meet({{0.25, 0.25, 1.0}, {0, 0, -3}}, kTriangle);
  EXPECT_LE(through.tLower, 1.0 / 3.0);
  EXPECT_GE(through.tUpper, 1.0 / 3.0);
  EXPECT_LE(through.tUpper - through.tLower, 1e-15);
  // In the plane of the triangle it is what lies between the edges.
  const ExactMeeting along = meet({{-1.0, 0.25, 0.0}, {1, 0, 0}}, kTriangle);
  EXPECT_EQ(along.kind, Meeting::Touching);
  EXPECT_EQ(along.tLower, 1.0);
  EXPECT_EQ(along.tUpper, 1.75);
  EXPECT_EQ(meet({{-1.0, 1.25, 0.0}, {1, 0, 0}}, kTriangle).kind, Meeting::Miss);
  EXPECT_EQ(meet({{-1.0, 0.25, kTiny}, {1, 0, 0}}, kTriangle).kind, Meeting::Miss);
}

TEST(Meet, MeasuresHowFarTheRayIsInsideOrOutside) {
  EXPECT_EQ(meet(down(0.25, 0.125), kTriangle).depth, 0.125);
  EXPECT_EQ(meet(down(0.25, -0.5), kTriangle).depth, -0.5);
  EXPECT_EQ(meet(down(-2.0, -3.0), kTriangle).depth, -3.0);
  // From the slanted edge, along both axes at once.
  EXPECT_EQ(meet(down(1.0, 1.0), kTriangle).depth, -0.5);
}

TEST(Meet, TakesTrianglesWithoutAreaForTheirSegments) {
  const Corners segment = {Vec3d{0, 0, 0}, Vec3d{1, 1, 0}, Vec3d{2, 2, 0}};
  EXPECT_EQ(meet(down(1.5, 1.5), segment).kind, Meeting::Touching);
  EXPECT_EQ(meet(down(1.5, std::nextafter(1.5, 2.0)), segment).kind, Meeting::Miss);
}

/// A square of two triangles, in the plane z = 0 from -1 to 1.
TriangleMesh<float> square() {
  return {.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
          .faces = {{0, 1, 2}, {0, 2, 3}},
          .sourceFaces = {}};
}

ExactJudge judgeOf(const TriangleMesh<float>& mesh) {
  return {cornersOf(mesh), buildTree(mesh.view()).bounds(), kBoundInRoundoffs<float>, 0x1p-24};
}

TEST(Patches, JoinTrianglesWhereTheRayIsNearTheirEdge) {
  const ExactJudge judge = judgeOf(square());
  const Expectation atEdge = judge.expect(down(0.5, 0.5));
  ASSERT_EQ(atEdge.patches.size(), 1u);
  EXPECT_EQ(atEdge.patches[0].faces.size(), 2u);
  EXPECT_TRUE(atEdge.patches[0].isCertain);
  EXPECT_EQ(atEdge.patches[0].winding, -1) << "the ray comes from the front";
  EXPECT_EQ(atEdge.touchingCount, 2u);

  const Expectation inside = judge.expect(down(0.5, 0.0));
  ASSERT_EQ(inside.patches.size(), 1u);
  EXPECT_EQ(inside.patches[0].faces, std::vector<std::uint32_t>{0});
  EXPECT_TRUE(inside.patches[0].mustBeHit(0.0, kInfinity));
  EXPECT_LT(inside.patches[0].tLower, 2.0);
  EXPECT_GT(inside.patches[0].tUpper, 2.0);
  EXPECT_TRUE(inside.patches[0].mustBeHit(0.0, inside.patches[0].tUpper));
  EXPECT_FALSE(inside.patches[0].mustBeHit(0.0, 2.0));
}

TEST(Patches, AreOpenWhereTheirOutlineIsWithinTheBound) {
  const ExactJudge judge = judgeOf(square());
  const double bound = 8.0 * 0x1p-24 * 2.0;
  for (const double aside : {0.0, 0.9 * bound, -0.9 * bound}) {
    const Expectation atOutline = judge.expect(down(1.0 - aside, 0.25));
    ASSERT_EQ(atOutline.patches.size(), 1u);
    EXPECT_FALSE(atOutline.patches[0].isCertain);
  }
  ASSERT_EQ(judge.expect(down(1.0 - 1.1 * bound, 0.25)).patches.size(), 1u);
  EXPECT_TRUE(judge.expect(down(1.0 - 1.1 * bound, 0.25)).patches[0].isCertain);
  EXPECT_TRUE(judge.expect(down(1.0 + 1.1 * bound, 0.25)).patches.empty());
}

TEST(Patches, HaveALongWindowWhereTheTriangleIsNearlyEdgeOn) {
  const TriangleMesh<float> wall{.positions = {{-1, 0, -1}, {1, 0, -1}, {0, 0x1p-20f, 1}},
                                 .faces = {{0, 1, 2}},
                                 .sourceFaces = {}};
  const Expectation along = judgeOf(wall).expect(down(0.0, 0x1p-21));
  ASSERT_EQ(along.patches.size(), 1u);
  EXPECT_GT(along.patches[0].tUpper - along.patches[0].tLower, 0.5);
}

// Most triangles are ruled out in double, without the exact kernel.
TEST(Patches, HoldAllTrianglesWhoseOutlineIsNearAndNoOthers) {
  Random random(81);
  const TriangleMesh<float> mesh = detail::soup<float>(82, 60, 0.5, {1, 1, 1e-3});
  const std::vector<Corners> faces = cornersOf(mesh);
  const ExactJudge judge = judgeOf(mesh);
  const Box3 bounds = buildTree(mesh.view()).bounds();
  int nearCount = 0;
  for (int i = 0; i < 400; ++i) {
    const auto face = static_cast<std::uint32_t>(random.below(faces.size()));
    const Vec3d onEdge =
        faces[face][0] + (faces[face][1] - faces[face][0]) * random.between(-0.1, 1.1);
    const Vec3d origin = random.pointIn<double>({-3, -3, -3}, {3, 3, 3});
    Rayd ray{origin, onEdge - origin};
    // At most two units of the bound aside.
    ray.direction.x += random.between(-2.0, 2.0) * 8.0 * 0x1p-24 * 3.0;
    double distance = 0.0;
    for (const Axis axis : kAxes) {
      distance =
          std::max({distance, std::fabs(static_cast<double>(bounds.lower[axis]) - origin[axis]),
                    std::fabs(static_cast<double>(bounds.upper[axis]) - origin[axis])});
    }
    const Expectation expectation = judge.expect(ray);
    for (std::uint32_t other = 0; other < faces.size(); ++other) {
      const bool isNear = meet(ray, faces[other]).depth >= -8.0 * 0x1p-24 * distance;
      ASSERT_EQ(expectation.patchOf(other) != nullptr, isNear) << "face " << other;
      nearCount += isNear ? 1 : 0;
    }
  }
  EXPECT_GT(nearCount, 400);
}

/// The verdict on answers that were tampered with; every kind of fault has to be noticed.
class TamperedAnswers : public testing::Test {
 protected:
  TamperedAnswers() {
    mesh_ = square();
    mesh_.positions.insert(mesh_.positions.end(), {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}});
    mesh_.faces.push_back({4, 5, 6});
  }

  [[nodiscard]] std::uint64_t wrongAnswers(const auto& tamper, const Rayf& ray = kRay) const {
    const KdTree<Face<float>> tree = buildTree(mesh_.view());
    Answers<float> answers = ask(tree, std::vector<Rayf>{ray}).front();
    tamper(answers);
    Verdicts verdicts;
    AnswerJudge<float>(mesh_, tree.bounds()).judge(ray, answers, verdicts);
    return verdicts.wrongAnswers;
  }

  static constexpr Rayf kRay{.origin = {0.5f, 0.25f, 2}, .direction = {0, 0, -1}};
  TriangleMesh<float> mesh_;
};

TEST_F(TamperedAnswers, AreRightIfNothingWasDone) {
  EXPECT_EQ(wrongAnswers([](Answers<float>&) {}), 0u);
}

TEST_F(TamperedAnswers, AreWrongIfAHitIsLost) {
  EXPECT_EQ(wrongAnswers([](Answers<float>& a) {
              a.nearest.reset();
              a.nearestOfBatch = {};
            }),
            1u);
  EXPECT_EQ(wrongAnswers([](Answers<float>& a) { a.any = a.anyOfBatch = false; }), 1u);
  EXPECT_EQ(wrongAnswers([](Answers<float>& a) { a.all.pop_back(); }), 1u);
  EXPECT_EQ(wrongAnswers([](Answers<float>& a) { a.crossings.pop_back(); }), 1u);
}

TEST_F(TamperedAnswers, AreWrongIfAFartherHitIsTakenForTheNearest) {
  EXPECT_EQ(wrongAnswers([](Answers<float>& a) { a.nearest = a.nearestOfBatch = a.all.back(); }),
            1u);
}

TEST_F(TamperedAnswers, AreWrongIfAPointIsBeyondTheBound) {
  const auto moveBy = [](float distance) {
    return [distance](Answers<float>& a) {
      a.nearest->t += distance;
      a.nearestOfBatch = *a.nearest;
    };
  };
  // D is 3: from the origin to the lower triangle.
  EXPECT_EQ(wrongAnswers(moveBy(7 * 0x1p-24f * 3)), 0u);
  EXPECT_EQ(wrongAnswers(moveBy(9 * 0x1p-24f * 3)), 1u);
  EXPECT_EQ(wrongAnswers([](Answers<float>& a) { a.all.back().primitive = 1; }), 1u);
}

TEST_F(TamperedAnswers, AreWrongIfAHitIsInvented) {
  const Rayf beside{.origin = {5, 0, 2}, .direction = {0, 0, -1}};
  EXPECT_EQ(wrongAnswers([](Answers<float>&) {}, beside), 0u);
  EXPECT_EQ(wrongAnswers([](Answers<float>& a) { a.any = a.anyOfBatch = true; }, beside), 1u);
  const auto hit = [](Answers<float>& a) {
    a.nearest = Hitf{.t = 2, .geometry = 0, .primitive = 0};
    a.nearestOfBatch = *a.nearest;
  };
  EXPECT_EQ(wrongAnswers(hit, beside), 1u);
}

TEST_F(TamperedAnswers, AreWrongIfOrderSideOrBatchAreDifferent) {
  EXPECT_EQ(wrongAnswers([](Answers<float>& a) { std::swap(a.all[0], a.all[1]); }), 1u);
  EXPECT_EQ(wrongAnswers([](Answers<float>& a) { a.all.push_back(a.all.back()); }), 1u);
  EXPECT_EQ(wrongAnswers([](Answers<float>& a) { a.crossings[0].normal = -a.crossings[0].normal; }),
            1u);
  EXPECT_EQ(wrongAnswers([](Answers<float>& a) {
              a.nearestOfBatch.t = std::nextafter(a.nearestOfBatch.t, 9.0f);
            }),
            1u);
  EXPECT_EQ(wrongAnswers([](Answers<float>& a) { a.anyOfBatch = false; }), 1u);
}

template <class T>
class InnerPoints : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(InnerPoints, Scalars);

// That is what the leak test takes for granted. Whether a point is inside is told by the winding of
// the mesh around a ray from it, without any bound but for the patches that must be certain.
TYPED_TEST(InnerPoints, OfTheClosedSolidsAreInside) {
  using T = TypeParam;
  for (const PlacedSolid<T>& solid : placedSolids<T>()) {
    SCOPED_TRACE(solid.name + ", " + solid.placement);
    const Box3 bounds = buildTree(solid.mesh.view()).bounds();
    const ExactJudge judge(cornersOf(solid.mesh), bounds, kBoundInRoundoffs<T>,
                           static_cast<double>(std::numeric_limits<T>::epsilon()) / 2.0);
    FastRandom random(71);
    std::size_t judged = 0;
    for (int i = 0; i < 24; ++i) {
      const std::size_t face = random.below(solid.mesh.faces.size());
      const Vec3<T> point =
          i % 2 == 0 ? innerPoint(solid, face, random) : innerPointAtSurface(solid, face, random);
      const Expectation expectation =
          judge.expect({static_cast<Vec3d>(point), random.inCube(), 0.0, kInfinity});
      int winding = 0;
      bool isCertain = true;
      for (const Patch& patch : expectation.patches) {
        // Nothing is near the point itself, or the test could take it for outside.
        ASSERT_FALSE(patch.tLower < 0.0 && patch.tUpper > 0.0 && patch.isCertain &&
                     patch.winding != 0);
        isCertain = isCertain && patch.isCertain;
        winding += patch.tLower >= 0.0 ? patch.winding : 0;
      }
      if (!isCertain)
        continue;
      ++judged;
      ASSERT_EQ(winding, 1) << (i % 2 == 0 ? "at the core" : "at the surface");
    }
    EXPECT_GT(judged, 20u);
  }
}

}  // namespace
}  // namespace planetree::test
