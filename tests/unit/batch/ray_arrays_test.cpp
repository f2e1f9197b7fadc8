#include <planetree/batch/ray_arrays.hpp>

#include <planetree/planetree.hpp>

#include "support/batch_rays.hpp"
#include "support/batch_scenes.hpp"
#include "support/compare_batches.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <regex>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace planetree {
namespace {

using test::SingleAnswers;

/// Rays as an array for each number, and room for hits.
template <class T>
struct Columns {
  std::vector<T> ox, oy, oz, dx, dy, dz, tMin, tMax;
  std::vector<T> t, u, v, nx, ny, nz;
  std::vector<std::uint32_t> geometry, primitive, part;

  explicit Columns(std::span<const Ray<T>> rays) {
    for (const Ray<T>& ray : rays) {
      ox.push_back(ray.origin.x);
      oy.push_back(ray.origin.y);
      oz.push_back(ray.origin.z);
      dx.push_back(ray.direction.x);
      dy.push_back(ray.direction.y);
      dz.push_back(ray.direction.z);
      tMin.push_back(ray.tMin);
      tMax.push_back(ray.tMax);
    }
    for (std::vector<T>* const column : {&t, &u, &v, &nx, &ny, &nz})
      column->assign(rays.size(), T(-77));
    for (std::vector<std::uint32_t>* const column : {&geometry, &primitive, &part})
      column->assign(rays.size(), 77);
  }

  [[nodiscard]] RayArrays<T> rays() const { return {ox, oy, oz, dx, dy, dz, tMin, tMax}; }
  [[nodiscard]] HitArrays<T> hits() { return {t, u, v, nx, ny, nz, geometry, primitive, part}; }
  [[nodiscard]] Hit<T> hit(std::size_t i) const {
    return {.t = t[i],
            .u = u[i],
            .v = v[i],
            .normal = {nx[i], ny[i], nz[i]},
            .geometry = geometry[i],
            .primitive = primitive[i],
            .part = part[i]};
  }
};

template <class T>
class RayArraysTest : public testing::Test {
 protected:
  RayArraysTest() {
    Scene<T> scene;
    scene.add(test::detail::soup<T>(401, 300, 0.3));
    scene.add(test::someSpheres<T>(402, 30));
    tree_ = buildTree(scene);
    picture_ = test::raySets(TriangleMesh<T>{}, tree_.bounds(), 403).front().rays;
    const auto hard = test::hardRays(TriangleMesh<T>{}, tree_.bounds(), 3000, 404);
    rays_ = test::withBadRays(test::mixed(picture_, hard, 405), 406);
  }

  KdTree<AnyObject<T>> tree_;
  std::vector<Ray<T>> picture_;
  std::vector<Ray<T>> rays_;  ///< with intervals of all kinds
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(RayArraysTest, Scalars);

TYPED_TEST(RayArraysTest, BatchAnswersAsSingleRaysDo) {
  using T = TypeParam;
  for (const auto& rays : {this->rays_, this->picture_}) {
    const SingleAnswers<T> alone(this->tree_.view(), rays);
    EXPECT_GT(alone.hitCount, rays.size() / 10);
    Columns<T> columns(rays);
    EXPECT_EQ(this->tree_.findIntersections(columns.rays(), columns.hits()), alone.hitCount);
    for (std::size_t i = 0; i < rays.size(); ++i)
      ASSERT_TRUE(test::hasSameBits(columns.hit(i), alone.hits[i])) << test::describeRay(rays[i]);
    std::vector<std::uint8_t> flags(rays.size(), test::kUntouchedFlag);
    EXPECT_EQ(this->tree_.areOccluded(columns.rays(), flags), alone.hitCount);
    test::expectSameFlags(flags, alone.flags);
  }
}

TYPED_TEST(RayArraysTest, BatchWithoutLimitsHasThoseOfADefaultMadeRay) {
  using T = TypeParam;
  for (const bool hasTMin : {false, true}) {
    for (const bool hasTMax : {false, true}) {
      SCOPED_TRACE(testing::Message() << "tMin " << hasTMin << ", tMax " << hasTMax);
      std::vector<Ray<T>> rays = this->rays_;
      for (Ray<T>& ray : rays) {
        if (!hasTMin)
          ray.tMin = T(0);
        if (!hasTMax)
          ray.tMax = std::numeric_limits<T>::infinity();
      }
      const SingleAnswers<T> alone(this->tree_.view(), rays);
      Columns<T> columns(rays);
      RayArrays<T> arrays = columns.rays();
      if (!hasTMin)
        arrays.tMin = {};
      if (!hasTMax)
        arrays.tMax = {};
      EXPECT_EQ(this->tree_.findIntersections(arrays, columns.hits()), alone.hitCount);
      for (std::size_t i = 0; i < rays.size(); ++i)
        ASSERT_TRUE(test::hasSameBits(columns.hit(i), alone.hits[i]));
      std::vector<std::uint8_t> flags(rays.size(), test::kUntouchedFlag);
      EXPECT_EQ(this->tree_.areOccluded(arrays, flags), alone.hitCount);
      test::expectSameFlags(flags, alone.flags);
    }
  }
}

TYPED_TEST(RayArraysTest, BatchWritesTheColumnsThatAreWantedAndNoOther) {
  using T = TypeParam;
  const SingleAnswers<T> alone(this->tree_.view(), this->rays_);
  constexpr unsigned kColumnCount = 9;
  // Each alone, all but each, and none.
  std::vector<unsigned> wanted = {0};
  for (unsigned i = 0; i < kColumnCount; ++i) {
    wanted.push_back(1u << i);
    wanted.push_back(((1u << kColumnCount) - 1) & ~(1u << i));
  }
  for (const unsigned bits : wanted) {
    SCOPED_TRACE(bits);
    Columns<T> columns(this->rays_);
    HitArrays<T> hits = columns.hits();
    unsigned bit = 1;
    for (std::span<T>* const column :
         {&hits.t, &hits.u, &hits.v, &hits.normalX, &hits.normalY, &hits.normalZ}) {
      if ((bits & bit) == 0)
        *column = {};
      bit <<= 1u;
    }
    for (std::span<std::uint32_t>* const column : {&hits.geometry, &hits.primitive, &hits.part}) {
      if ((bits & bit) == 0)
        *column = {};
      bit <<= 1u;
    }
    EXPECT_EQ(this->tree_.findIntersections(columns.rays(), hits), alone.hitCount);
    for (std::size_t i = 0; i < this->rays_.size(); ++i) {
      Hit<T> expected = test::untouchedHit<T>();
      const Hit<T>& hit = alone.hits[i];
      expected.u = expected.v = T(-77);
      expected.normal = {T(-77), T(-77), T(-77)};
      expected.instance = 0;
      expected.t = (bits & 1u) != 0 ? hit.t : expected.t;
      expected.u = (bits & 2u) != 0 ? hit.u : expected.u;
      expected.v = (bits & 4u) != 0 ? hit.v : expected.v;
      expected.normal.x = (bits & 8u) != 0 ? hit.normal.x : expected.normal.x;
      expected.normal.y = (bits & 16u) != 0 ? hit.normal.y : expected.normal.y;
      expected.normal.z = (bits & 32u) != 0 ? hit.normal.z : expected.normal.z;
      expected.geometry = (bits & 64u) != 0 ? hit.geometry : expected.geometry;
      expected.primitive = (bits & 128u) != 0 ? hit.primitive : expected.primitive;
      expected.part = (bits & 256u) != 0 ? hit.part : expected.part;
      ASSERT_TRUE(test::hasSameBits(columns.hit(i), expected)) << i;
    }
  }
}

TYPED_TEST(RayArraysTest, BatchHonoursTheChoicesOfItsQuery) {
  using T = TypeParam;
  for (const QueryOptions& query :
       {QueryOptions{.mask = 0}, QueryOptions{.cullsBackFaces = true},
        QueryOptions{.crossings = true}, QueryOptions{.skip = {0, 17}}}) {
    const SingleAnswers<T> alone(this->tree_.view(), this->rays_, query);
    Columns<T> columns(this->rays_);
    EXPECT_EQ(this->tree_.findIntersections(columns.rays(), columns.hits(), {.query = query}),
              alone.hitCount);
    for (std::size_t i = 0; i < this->rays_.size(); ++i)
      ASSERT_TRUE(test::hasSameBits(columns.hit(i), alone.hits[i]));
  }
}

/// Expects the error about spans of unlike size, and that it names one of them.
void expectRefused(const std::function<void()>& ask, const std::string& column) {
  SCOPED_TRACE(column);
  try {
    ask();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InvalidOption);
    EXPECT_TRUE(std::regex_search(error.what(), std::regex("\\b" + column + "\\b")))
        << error.what();
    EXPECT_FALSE(error.advice().empty());
  }
}

TYPED_TEST(RayArraysTest, BatchRefusesColumnsOfAnotherSizeByTheirName) {
  using T = TypeParam;
  Columns<T> columns(this->rays_);
  const std::size_t count = this->rays_.size();
  std::vector<std::uint8_t> flags(count, test::kUntouchedFlag);
  const std::vector<T> tooMany(count + 1);
  const std::vector<std::pair<std::span<const T> RayArrays<T>::*, std::string>> inputs = {
      {&RayArrays<T>::originY, "originY"},
      {&RayArrays<T>::originZ, "originZ"},
      {&RayArrays<T>::directionX, "directionX"},
      {&RayArrays<T>::directionY, "directionY"},
      {&RayArrays<T>::directionZ, "directionZ"},
      {&RayArrays<T>::tMin, "tMin"},
      {&RayArrays<T>::tMax, "tMax"}};
  for (const auto& [member, name] : inputs) {
    for (const std::size_t size : {std::size_t{1}, count - 1, count + 1}) {
      RayArrays<T> rays = columns.rays();
      rays.*member = std::span(tooMany).first(size);
      expectRefused([&] { this->tree_.findIntersections(rays, columns.hits()); }, name);
      expectRefused([&] { this->tree_.areOccluded(rays, flags); }, name);
    }
  }
  RayArrays<T> withoutX = columns.rays();
  withoutX.originX = {};
  EXPECT_THROW(this->tree_.findIntersections(withoutX, columns.hits()), Error);
  withoutX = columns.rays();
  withoutX.directionZ = {};
  expectRefused([&] { this->tree_.findIntersections(withoutX, columns.hits()); }, "directionZ");

  std::vector<T> room(count + 1);
  const std::vector<std::pair<std::span<T> HitArrays<T>::*, std::string>> outputs = {
      {&HitArrays<T>::t, "t"},
      {&HitArrays<T>::u, "u"},
      {&HitArrays<T>::v, "v"},
      {&HitArrays<T>::normalX, "normalX"},
      {&HitArrays<T>::normalY, "normalY"},
      {&HitArrays<T>::normalZ, "normalZ"}};
  std::vector<std::uint32_t> idRoom(count + 1);
  const std::vector<std::pair<std::span<std::uint32_t> HitArrays<T>::*, std::string>> ids = {
      {&HitArrays<T>::geometry, "geometry"},
      {&HitArrays<T>::primitive, "primitive"},
      {&HitArrays<T>::part, "part"}};
  for (const std::size_t size : {std::size_t{1}, count - 1, count + 1}) {
    for (const auto& [member, name] : outputs) {
      HitArrays<T> hits = columns.hits();
      hits.*member = std::span(room).first(size);
      expectRefused([&] { this->tree_.findIntersections(columns.rays(), hits); }, name);
    }
    for (const auto& [member, name] : ids) {
      HitArrays<T> hits = columns.hits();
      hits.*member = std::span(idRoom).first(size);
      expectRefused([&] { this->tree_.findIntersections(columns.rays(), hits); }, name);
    }
  }
  const Columns<T> untouched(this->rays_);
  EXPECT_EQ(columns.t, untouched.t) << "nothing is answered before all is known to fit";
  EXPECT_EQ(columns.part, untouched.part);
}

TYPED_TEST(RayArraysTest, BatchRefusesTooLittleAndTooMuchRoom) {
  using T = TypeParam;
  const std::span<const Ray<T>> rays = this->rays_;
  std::vector<Hit<T>> hits(rays.size() + 1, test::untouchedHit<T>());
  std::vector<std::uint8_t> flags(rays.size() + 1, test::kUntouchedFlag);
  Columns<T> columns(rays);
  for (const std::size_t size : {std::size_t{0}, rays.size() - 1, rays.size() + 1}) {
    expectRefused([&] { this->tree_.findIntersections(rays, std::span(hits).first(size)); },
                  "hits");
    expectRefused([&] { this->tree_.areOccluded(rays, std::span(flags).first(size)); }, "flags");
    expectRefused([&] { this->tree_.areOccluded(columns.rays(), std::span(flags).first(size)); },
                  "flags");
  }
  EXPECT_TRUE(test::hasSameBits(hits.front(), test::untouchedHit<T>()));
  EXPECT_EQ(flags.front(), test::kUntouchedFlag);
}

}  // namespace
}  // namespace planetree
