#include <planetree/planetree.hpp>

#include "support/batch_rays.hpp"
#include "support/batch_scenes.hpp"
#include "support/compare_batches.hpp"
#include "support/flush_to_zero.hpp"

#include <gtest/gtest.h>

#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace planetree {
namespace {

/// Enough rays for several threads to have some of them, and what they say alone.
class BatchThreads : public testing::Test {
 protected:
  /// From any thread, where the checks of GoogleTest are not for everyone.
  [[nodiscard]] bool agrees(std::uint32_t threadCount) const {
    std::vector<Hitf> hits(rays_.size());
    std::vector<std::uint8_t> flags(rays_.size());
    const BatchOptions options = {.threadCount = threadCount};
    if (tree_.findIntersections(rays_, hits, options) != alone_.hitCount ||
        tree_.areOccluded(rays_, flags, options) != alone_.hitCount || flags != alone_.flags)
      return false;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (!test::hasSameBits(hits[i], alone_.hits[i]))
        return false;
    }
    return true;
  }

  static std::vector<Rayf> someRays(const Box3& bounds) {
    const test::PictureFrame<float> frame{{0.2f, 0.3f, -1}, {1, 0, 0}, {0, 1, 0}};
    const auto picture = test::pinholePicture<float>({0.1f, 0.2f, 1.5f}, frame, 150, 140);
    const auto random = test::randomRays<float>(bounds, 21'000, 601);
    return test::withBadRays(test::mixed(picture, random, 602), 603);
  }

  KdTree<Face<float>> tree_ = buildTree(test::room<float>());
  std::vector<Rayf> rays_ = someRays(tree_.bounds());
  test::SingleAnswers<float> alone_{tree_.view(), rays_};
};

TEST_F(BatchThreads, AnyNumberOfThemGivesTheSameAnswers) {
  for (const std::uint32_t threadCount : {0u, 1u, 2u, 3u, 1000u})
    EXPECT_TRUE(agrees(threadCount)) << threadCount;
}

TEST_F(BatchThreads, SeveralBatchesRunAtOnceFromThreadsOfTheCaller) {
  std::atomic<int> failures = 0;
  std::vector<std::thread> threads;
  for (std::uint32_t i = 0; i < 4; ++i) {
    threads.emplace_back([this, i, &failures] {
      for (std::uint32_t threadCount = 0; threadCount < 3; ++threadCount)
        failures += agrees((threadCount + i) % 3) ? 0 : 1;
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(failures, 0);
}

TEST_F(BatchThreads, BatchesRunInsideAParallelLoopOfTheCaller) {
  std::atomic<int> failures = 0;
  tbb::parallel_for(0, 12,
                    [&](int i) { failures += agrees(static_cast<std::uint32_t>(i % 4)) ? 0 : 1; });
  EXPECT_EQ(failures, 0);
}

TEST_F(BatchThreads, ABatchInsideACancelledGroupOfTheCallerAnswersAllRays) {
  for (const std::uint32_t threadCount : {0u, 2u}) {
    tbb::task_group group;
    bool isRight = false;
    group.run_and_wait([&] {
      group.cancel();
      isRight = agrees(threadCount);
    });
    EXPECT_TRUE(isRight) << threadCount;
  }
}

TEST_F(BatchThreads, AllThreadsFlushDenormalsAsTheCallerDoes) {
  struct Witness {
    bool flushes = false;
    std::atomic<int> others = 0;

    static bool isFlushed() noexcept {
      const volatile float denormal = 0x1p-130f;
      return denormal * 0.5f == 0.0f;
    }
  };
  // A first batch, so that oneTBB has seen threads that do not flush.
  EXPECT_TRUE(agrees(0));
  const test::FlushToZero mode(true);
  Witness witness;
  witness.flushes = Witness::isFlushed();
  const HitFilter filter(
      [](const Hitf&, void* context) noexcept {
        Witness& seen = *static_cast<Witness*>(context);
        if (Witness::isFlushed() != seen.flushes)
          ++seen.others;
        return true;
      },
      &witness);
  std::vector<Hitf> hits(rays_.size());
  for (const std::uint32_t threadCount : {0u, 1u, 2u}) {
    static_cast<void>(tree_.findIntersections(
        rays_, hits, {.query = {.filter = filter}, .threadCount = threadCount}));
    EXPECT_EQ(witness.others, 0) << threadCount;
  }
}

TEST_F(BatchThreads, ABatchWithOneThreadStaysInTheThreadOfTheCaller) {
  struct Witness {
    std::thread::id caller = std::this_thread::get_id();
    std::atomic<int> others = 0;
  } witness;
  const HitFilter filter(
      [](const Hitf&, void* context) noexcept {
        Witness& seen = *static_cast<Witness*>(context);
        if (std::this_thread::get_id() != seen.caller)
          ++seen.others;
        return true;
      },
      &witness);
  std::vector<Hitf> hits(rays_.size());
  const std::size_t hitCount =
      tree_.findIntersections(rays_, hits, {.query = {.filter = filter}, .threadCount = 1});
  EXPECT_EQ(hitCount, alone_.hitCount);
  EXPECT_EQ(witness.others, 0);
}

}  // namespace
}  // namespace planetree
