#include <planetree/planetree.hpp>

#include "support/batch_rays.hpp"
#include "support/batch_scenes.hpp"
#include "support/compare_batches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace planetree {
namespace {

template <class T>
class BatchSizes : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BatchSizes, Scalars);

TYPED_TEST(BatchSizes, AllGiveTheAnswersOfSingleRays) {
  using T = TypeParam;
  const auto tree = buildTree(test::room<T>());
  const test::PictureFrame<T> frame{{T(0.2), T(0.3), -1}, {1, 0, 0}, {0, 1, 0}};
  const auto picture = test::pinholePicture<T>({T(0.1), T(0.2), T(1.5)}, frame, 80, 63);
  const auto random = test::randomRays<T>(tree.bounds(), 5040, 501);
  for (const auto& rays : {picture, random, test::mixed(picture, random, 502)}) {
    for (const std::size_t count :
         {0u,  1u,  2u,  7u,   8u,   9u,   15u,  16u,   17u,   31u,   33u,
          63u, 64u, 65u, 127u, 129u, 255u, 257u, 1000u, 1024u, 1025u, 5000u}) {
      SCOPED_TRACE(count);
      // Not only from where the allocator aligns it.
      for (const std::size_t first : {0u, 1u, 39u}) {
        const std::span<const Ray<T>> part = std::span(rays).subspan(first, count);
        test::expectAnswers<T>(tree.view(), part, test::SingleAnswers<T>(tree.view(), part));
      }
    }
  }
}

TYPED_TEST(BatchSizes, AnswersDoNotDependOnHowRaysAreDividedIntoBatches) {
  using T = TypeParam;
  const auto tree = buildTree(test::room<T>());
  const auto rays = test::raySets(test::room<T>(), tree.bounds(), 503).front().rays;
  std::vector<Hit<T>> whole(rays.size());
  tree.findIntersections(rays, whole);
  for (const std::size_t size : {1u, 5u, 16u, 100u}) {
    std::vector<Hit<T>> parts(rays.size());
    for (std::size_t i = 0; i < rays.size(); i += size) {
      const std::size_t count = std::min(size, rays.size() - i);
      tree.findIntersections(std::span(rays).subspan(i, count), std::span(parts).subspan(i, count));
    }
    test::expectSameHits<T>(rays, parts, whole);
  }
}

TYPED_TEST(BatchSizes, OfZeroNeedNoArrays) {
  using T = TypeParam;
  const auto tree = buildTree(test::room<T>());
  EXPECT_EQ(tree.findIntersections(std::span<const Ray<T>>(), std::span<Hit<T>>()), 0u);
  EXPECT_EQ(tree.areOccluded(std::span<const Ray<T>>(), {}), 0u);
  EXPECT_EQ(tree.findIntersections(RayArrays<T>{}, HitArrays<T>{}), 0u);
  EXPECT_EQ(tree.areOccluded(RayArrays<T>{}, {}), 0u);
}

TYPED_TEST(BatchSizes, OfATreeWithoutObjectsAnswerThatNothingIsHit) {
  using T = TypeParam;
  const KdTree<Face<T>> tree;
  const auto rays = test::randomRays<T>({{-1, -1, -1}, {1, 1, 1}}, 5000, 504);
  test::expectSameAsAlone(tree.view(), rays);
}

}  // namespace
}  // namespace planetree
