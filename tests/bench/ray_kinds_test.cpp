#include "bench/support/ray_kinds.hpp"

#include "bench/scene/cameras.hpp"

#include "bench_meshes.hpp"

#include <planetree/build_tree.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace planetree::bench {
namespace {

constexpr RayCounts kFew = {.pictureSize = 48, .randomCount = 5000};
const std::vector<RayKind> kAllKinds(kRayKinds.begin(), kRayKinds.end());

std::vector<RaySet> ballRays(const std::vector<RayKind>& kinds = kAllKinds) {
  const BenchScene scene = test::ballScene();
  return makeRaySets(scene.mesh, scene.camera, kinds, kFew);
}

const std::vector<Rayf>& raysOf(const std::vector<RaySet>& sets, RayKind kind) {
  return std::find_if(sets.begin(), sets.end(), [&](const RaySet& s) { return s.kind == kind; })
      ->rays;
}

bool haveSameBits(const std::vector<Rayf>& a, const std::vector<Rayf>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Rayf)) == 0;
}

double sizeOf(const Vec3f& v) {
  return length(Vec3d(v));
}

TEST(RayKinds, AreTheSameEachTime) {
  const auto first = ballRays();
  const auto second = ballRays();
  ASSERT_EQ(first.size(), 4u);
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_TRUE(haveSameBits(first[i].rays, second[i].rays)) << rayKindName(first[i].kind);
}

TEST(RayKinds, DoNotDependOnWhichOthersAreAskedFor) {
  const auto all = ballRays();
  for (const RayKind kind : kRayKinds)
    EXPECT_TRUE(haveSameBits(raysOf(all, kind), ballRays({kind}).front().rays))
        << rayKindName(kind);
}

TEST(RayKinds, HaveUnitDirectionsAndBeginAtZero) {
  for (const RaySet& set : ballRays()) {
    for (const Rayf& ray : set.rays) {
      ASSERT_NEAR(sizeOf(ray.direction), 1.0, 1e-6) << rayKindName(set.kind);
      ASSERT_EQ(ray.tMin, 0.0f);
    }
  }
}

TEST(RayKinds, OnlyOcclusionRaysEndAndAskForAnyHit) {
  const double diagonal = test::ballScene().diagonal;
  for (const RaySet& set : ballRays()) {
    const bool isOcclusion = set.kind == RayKind::AmbientOcclusion;
    EXPECT_EQ(asksForAnyHit(set.kind), isOcclusion);
    for (const Rayf& ray : set.rays) {
      if (isOcclusion)
        ASSERT_NEAR(ray.tMax, 0.15 * diagonal, 1e-5 * diagonal);
      else
        ASSERT_EQ(ray.tMax, std::numeric_limits<float>::infinity());
    }
  }
}

TEST(RayKinds, PrimaryRaysAreThePixelsRowByRow) {
  const auto rays = raysOf(ballRays(), RayKind::Primary);
  ASSERT_EQ(rays.size(), 48u * 48u);
  const BenchScene scene = test::ballScene();
  const render::CameraAxes axes =
      render::cameraAxes(Vec3d(scene.camera.at) - Vec3d(scene.camera.eye), {0.0, 1.0, 0.0});
  const auto across = [&](std::size_t i) { return dot(Vec3d(rays[i].direction), axes.right); };
  const auto upward = [&](std::size_t i) { return dot(Vec3d(rays[i].direction), axes.up); };
  EXPECT_LT(across(0), across(1));
  EXPECT_GT(upward(0), upward(48));
  EXPECT_NEAR(across(0), -across(47), 1e-6);
  EXPECT_NEAR(upward(0), -upward(47 * 48), 1e-6);
  // The centre of the last pixel, half a pixel from the edge of 40 degrees.
  const double slope = std::tan(20.0 * std::numbers::pi / 180.0) * (47.0 / 48.0);
  EXPECT_NEAR(across(47) / dot(Vec3d(rays[47].direction), axes.forward), slope, 1e-6);
}

TEST(RayKinds, OnlyPrimaryRaysAreAPicture) {
  for (const RaySet& set : ballRays())
    EXPECT_EQ(set.pictureWidth, set.kind == RayKind::Primary ? 48u : 0u) << rayKindName(set.kind);
}

TEST(RayKinds, SecondaryRaysStartJustOffTheSurfaceTowardTheViewer) {
  const BenchScene scene = test::ballScene();
  const auto sets = ballRays();
  const auto tree = buildTree(scene.mesh.view());
  std::vector<Hitf> hits;
  std::vector<Rayf> hitting;
  for (const Rayf& ray : raysOf(sets, RayKind::Primary)) {
    if (const auto hit = tree.findIntersection(ray)) {
      hits.push_back(*hit);
      hitting.push_back(ray);
    }
  }
  ASSERT_GT(hits.size(), 500u);
  for (const RayKind kind : {RayKind::AmbientOcclusion, RayKind::Diffuse}) {
    const auto& rays = raysOf(sets, kind);
    ASSERT_EQ(rays.size(), hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const Vec3d surface(hitting[i].at(hits[i].t));
      const Vec3d moved = Vec3d(rays[i].origin) - surface;
      ASSERT_NEAR(length(moved), 2e-5 * scene.diagonal, 2e-6 * scene.diagonal);
      ASSERT_LT(dot(moved, Vec3d(hitting[i].direction)), 0.0);
      // Into the hemisphere on that side, but for what rounding the origin turns.
      ASSERT_GT(dot(Vec3d(rays[i].direction), moved), -0.05 * length(moved));
    }
  }
}

TEST(RayKinds, SecondaryDirectionsFollowTheCosine) {
  // Seen from straight above, a flat floor has the normal +y everywhere: the mean of the cosine is
  // 2/3 for the cosine distribution (and would be 1/2 for the uniform one).
  TriangleMesh<float> floor;
  addSurface(floor, 1, 1, [](double u, double v) { return Vec3d{u, 0.0, 1.0 - v}; });
  const auto sets = makeRaySets(floor, framingCamera(floor.positions), {RayKind::Diffuse},
                                {.pictureSize = 200, .randomCount = 0});
  double sum = 0.0;
  for (const Rayf& ray : sets.front().rays)
    sum += static_cast<double>(ray.direction.y);
  EXPECT_NEAR(sum / static_cast<double>(sets.front().rays.size()), 2.0 / 3.0, 0.01);
}

TEST(RayKinds, RandomRaysStartOffAFlatScene) {
  TriangleMesh<float> flat = test::ball();
  for (Vec3f& position : flat.positions)
    position.z = 0.0f;
  const BenchScene scene = makeScene("flat", std::move(flat));
  const auto sets = makeRaySets(scene.mesh, scene.camera, {RayKind::Random}, kFew);
  const auto& rays = sets.front().rays;
  const auto inPlane = std::count_if(
      rays.begin(), rays.end(), [](const Rayf& ray) { return std::fabs(ray.origin.z) < 1e-5f; });
  EXPECT_LT(inPlane, 50) << "of " << rays.size();
}

TEST(RayKinds, RandomRaysFillTheEnlargedBounds) {
  const auto rays = raysOf(ballRays(), RayKind::Random);
  ASSERT_EQ(rays.size(), 5000u);
  Box3 origins;
  Vec3d sum;
  for (const Rayf& ray : rays) {
    origins.extend(ray.origin);
    sum = sum + Vec3d(ray.direction);
  }
  for (const Axis axis : kAxes) {
    EXPECT_GE(origins.lower[axis], -1.1001f);
    EXPECT_LE(origins.upper[axis], 1.1001f);
    EXPECT_LT(origins.lower[axis], -1.09f);
    EXPECT_GT(origins.upper[axis], 1.09f);
  }
  EXPECT_LT(length(sum) / 5000.0, 0.03) << "directions lean to one side";
}

TEST(RayKinds, AMeshWithoutFacesHasPrimaryRaysOnly) {
  for (const RaySet& set : makeRaySets(TriangleMesh<float>(), {}, kAllKinds, kFew))
    EXPECT_EQ(set.rays.empty(), set.kind != RayKind::Primary) << rayKindName(set.kind);
}

}  // namespace
}  // namespace planetree::bench
