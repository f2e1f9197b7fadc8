#include <planetree/planetree.hpp>

#include "support/batch_rays.hpp"
#include "support/batch_scenes.hpp"
#include "support/compare_batches.hpp"

#include <gtest/gtest.h>

#include <pthread.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

/// Threads with little stack, as programs with many of them have.
namespace planetree::test {
namespace {

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PLANETREE_HAS_SANITIZER
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PLANETREE_HAS_SANITIZER
#endif

// Sanitizers, and code that was not optimised, take several times as much.
#if defined(PLANETREE_HAS_SANITIZER) || !defined(NDEBUG)
constexpr std::size_t kStackSize = 4'000'000;
#else
constexpr std::size_t kStackSize = 500'000;
#endif

/// Runs `work` on a thread with no more stack than that; beyond it the program would end.
void onSmallStack(std::size_t stackSize, std::function<void()> work) {
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  // Whole pages.
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, stackSize / 4096 * 4096), 0);
  pthread_t thread = {};
  ASSERT_EQ(pthread_create(
                &thread, &attributes,
                [](void* function) -> void* {
                  (*static_cast<std::function<void()>*>(function))();
                  return nullptr;
                },
                &work),
            0);
  EXPECT_EQ(pthread_join(thread, nullptr), 0);
  EXPECT_EQ(pthread_attr_destroy(&attributes), 0);
}

template <class T>
class SmallStack : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SmallStack, Scalars);

template <class T>
std::vector<Ray<T>> someRays(const Box3& bounds) {
  const PictureFrame<T> frame{{T(0.2), T(0.3), -1}, {1, 0, 0}, {0, 1, 0}};
  auto rays = pinholePicture<T>({T(0.1), T(0.2), T(1.5)}, frame, 100, 70);
  const auto more = randomRays<T>(bounds, 5000, 941);
  rays.insert(rays.end(), more.begin(), more.end());
  return withBadRays(rays, 942);
}

TYPED_TEST(SmallStack, IsEnoughForBatches) {
  using T = TypeParam;
  for (const BatchScene<T>& scene : batchScenes<T>()) {
    SCOPED_TRACE(scene.name);
    const auto rays = someRays<T>(scene.tree.bounds());
    const SingleAnswers<T> alone(scene.tree.view(), rays);
    onSmallStack(kStackSize, [&] {
      for (const std::uint32_t threadCount : {0u, 1u, 2u})
        expectAnswers<T>(scene.tree.view(), rays, alone, {.threadCount = threadCount});
    });
  }
}

TYPED_TEST(SmallStack, IsEnoughForBuildsAndSingleRays) {
  using T = TypeParam;
  const TriangleMesh<T> mesh = detail::soup<T>(943, 20'000, 0.05);
  BuildOptions deep;
  deep.depthLimit = kMaxTreeDepth;
  deep.stopsByCost = false;
  deep.leafSize = 1;
  deep.referencesPerObject = 4;
  for (BuildOptions options : {BuildOptions::fast(), BuildOptions::balanced(), BuildOptions::high(),
                               BuildOptions::textbook(), deep}) {
    options.threadCount = 1;
    onSmallStack(kStackSize, [&] {
      const auto tree = buildTree(mesh.view(), options);
      std::array<Hit<T>, 64> hits;
      for (const Ray<T>& ray : someRays<T>(tree.bounds())) {
        static_cast<void>(tree.findIntersection(ray));
        static_cast<void>(tree.isOccluded(ray));
        static_cast<void>(tree.findIntersections(ray, hits));
      }
      EXPECT_GT(tree.nodes().size(), 1u);
    });
  }
}

}  // namespace
}  // namespace planetree::test
