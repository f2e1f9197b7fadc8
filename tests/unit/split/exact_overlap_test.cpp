#include "unit/split/exact_overlap.hpp"

#include "unit/split/random_meshes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <stdexcept>

// The judge is judged first.
namespace planetree::test {
namespace {

constexpr Box3 kBox = {.lower = {0, 0, 0}, .upper = {4, 4, 4}};

using Triangle = std::array<Vec3f, 3>;
using Judge = OverlapJudge<0, 40>;

bool touchesInterior(const Triangle& triangle, const Box3& box = kBox) {
  return Judge(triangle).touches(box, Contact::Interior);
}

bool touchesClosed(const Triangle& triangle, const Box3& box = kBox) {
  return Judge(triangle).touches(box, Contact::Closed);
}

TEST(OverlapJudge, SeesTrianglesInsideAndAroundTheBox) {
  EXPECT_TRUE(touchesInterior({{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}}));
  EXPECT_TRUE(touchesInterior({{{-90, -90, 2}, {90, -90, 2}, {0, 90, 2}}}));
}

TEST(OverlapJudge, TellsTheBoundaryFromTheInterior) {
  const Triangle onWall = {{{0, 1, 1}, {0, 2, 1}, {0, 1, 2}}};
  EXPECT_FALSE(touchesInterior(onWall));
  EXPECT_TRUE(touchesClosed(onWall));
  const Triangle throughEdge = {{{4, 4, -9}, {4, 4, 9}, {9, 9, 0}}};
  EXPECT_FALSE(touchesInterior(throughEdge));
  EXPECT_TRUE(touchesClosed(throughEdge));
  const Triangle atCorner = {{{6, 3, 3}, {3, 6, 3}, {3, 3, 6}}};
  EXPECT_FALSE(touchesInterior(atCorner));
  EXPECT_TRUE(touchesClosed(atCorner));
}

TEST(OverlapJudge, MissesTrianglesWhoseBoxAloneTouches) {
  const Triangle besideCorner = {{{7, 3, 3}, {3, 7, 3}, {3, 3, 7}}};
  EXPECT_FALSE(touchesClosed(besideCorner));
  const Triangle besideEdge = {{{3, 6, -1}, {6, 3, -1}, {6, 3, 5}}};
  EXPECT_FALSE(touchesClosed(besideEdge));
}

TEST(OverlapJudge, TakesFacesWithoutAreaAsLines) {
  EXPECT_TRUE(touchesInterior({{{-1, -1, -1}, {2, 2, 2}, {5, 5, 5}}}));
  EXPECT_FALSE(touchesClosed({{{9, 0, 0}, {0, 9, 9}, {18, -9, -9}}}));
}

TEST(OverlapJudge, GrowsTheBoxByTheMargin) {
  const Judge judge(Triangle{{{5, 0, 0}, {5, 1, 0}, {5, 0, 1}}});
  EXPECT_FALSE(judge.touches(kBox, Contact::Closed));
  EXPECT_FALSE(judge.touches(kBox, Contact::Closed, 0.5));
  EXPECT_TRUE(judge.touches(kBox, Contact::Closed, 1.0));
  EXPECT_FALSE(judge.touches(kBox, Contact::Interior, 1.0));
}

TEST(OverlapJudge, RefusesWhatItsUnitCannotHold) {
  const Triangle triangle = {{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}};
  EXPECT_THROW(static_cast<void>(touchesClosed(triangle, {{0, 0, 0}, {0x1p-41f, 1, 1}})),
               std::range_error);
  EXPECT_THROW(Judge(Triangle{{{0.5f, 0, 0}, {1, 0, 0}, {0, 1, 0}}}), std::range_error);
}

// Points strictly inside a box prove contact; the judge must never deny it.
TEST(OverlapJudge, NeverDeniesAPointInsideTheBox) {
  constexpr std::uint32_t kSeed = 5'772;
  MeshGenerator generator(kSeed);
  int provenCount = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto mesh = generator.integerSoup<float>(1, 12, 6);
    const Triangle corners = mesh.view().corners(0);
    Box3 box;
    for (const Axis axis : kAxes) {
      box.lower[axis] = static_cast<float>(generator.between(0, 10));
      box.upper[axis] = box.lower[axis] + static_cast<float>(generator.between(1, 4));
    }
    const auto isInside = [&](const Vec3f& point) {
      for (const Axis axis : kAxes) {
        if (point[axis] <= box.lower[axis] || point[axis] >= box.upper[axis])
          return false;
      }
      return true;
    };
    bool isProven = false;
    for (int i = 0; i <= 16; ++i) {
      for (int j = 0; i + j <= 16; ++j) {
        isProven = isProven || isInside(corners[0] * static_cast<float>(16 - i - j) * 0.0625f +
                                        corners[1] * static_cast<float>(i) * 0.0625f +
                                        corners[2] * static_cast<float>(j) * 0.0625f);
      }
    }
    if (!isProven)
      continue;
    ++provenCount;
    EXPECT_TRUE(touchesInterior(corners, box)) << "seed " << kSeed << ", round " << round;
  }
  EXPECT_GT(provenCount, 100);
}

}  // namespace
}  // namespace planetree::test
