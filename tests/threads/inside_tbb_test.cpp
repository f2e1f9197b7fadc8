#include "threads/library_work.hpp"

#include "support/flush_to_zero.hpp"

#include <gtest/gtest.h>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <thread>

/// The library inside of a program's own oneTBB tasks.
namespace planetree::test {
namespace {

using namespace std::chrono_literals;

/// A thread that waits for itself would wait for ever; here it gives up. (The thread sanitizer does
/// not know `std::timed_mutex`.)
std::unique_lock<std::mutex> lockSoon(std::mutex& mutex) {
  const auto end = std::chrono::steady_clock::now() + 60s;
  std::unique_lock lock(mutex, std::try_to_lock);
  while (!lock && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(1ms);
    static_cast<void>(lock.try_lock());
  }
  return lock;
}

/// oneTBB runs as many threads as the machine has, unless it is told otherwise.
class InsideTbb : public testing::TestWithParam<int> {
 protected:
  /// Calls `task(turn)` for each of `count` turns, each as a task of its own, in an arena of the
  /// caller's with as many threads as the test's parameter says.
  template <class Task>
  void runTasks(int count, const Task& task) {
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);
    tbb::task_arena arena(GetParam());
    arena.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<int>(0, count, 1),
          [&](const tbb::blocked_range<int>& range) {
            for (int turn = range.begin(); turn != range.end(); ++turn)
              task(turn);
          },
          tbb::simple_partitioner());
    });
  }

  const LibraryWork& work_ = libraryWork();
  std::atomic<int> failures_ = 0;
};

TEST_P(InsideTbb, AllIsAsOutside) {
  runTasks(12, [&](int turn) { failures_ += work_.doesTheSame(turn) ? 0 : 1; });
  EXPECT_EQ(failures_, 0);
}

// Who holds a lock, or a value of their thread, while the library waits for other threads must not
// find another of their tasks on the same thread.
TEST_P(InsideTbb, NoTaskOfTheCallerBeginsInsideOfABuild) {
  std::atomic<int> intrusions = 0;
  runTasks(24, [&](int turn) {
    intrusions += LibraryWork::isInside() ? 1 : 0;
    failures_ += work_.buildsTheSame(static_cast<std::uint32_t>(turn % 4)) ? 0 : 1;
  });
  EXPECT_EQ(intrusions, 0);
  EXPECT_EQ(failures_, 0);
}

TEST_P(InsideTbb, NoTaskOfTheCallerBeginsInsideOfABatch) {
  std::atomic<int> intrusions = 0;
  runTasks(200, [&](int turn) {
    intrusions += LibraryWork::isInside() ? 1 : 0;
    failures_ += work_.tracesTheSame(static_cast<std::uint32_t>(turn % 4)) ? 0 : 1;
  });
  EXPECT_EQ(intrusions, 0);
  EXPECT_EQ(failures_, 0);
}

TEST_P(InsideTbb, BuildsAndBatchesEndWhileTheCallerHoldsALock) {
  std::mutex mutex;
  runTasks(16, [&](int turn) {
    const std::unique_lock lock = lockSoon(mutex);
    if (!lock || !work_.doesTheSame(turn))
      ++failures_;
  });
  EXPECT_EQ(failures_, 0);
}

TEST_P(InsideTbb, AllIsAsOutsideWhereTheCallerIsolatesItsTasks) {
  runTasks(8, [&](int turn) {
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(0, 2, [&](int i) { failures_ += work_.doesTheSame(turn + i) ? 0 : 1; });
    });
  });
  EXPECT_EQ(failures_, 0);
}

TEST_P(InsideTbb, ValuesOfTheCallersThreadsStayAsTheyAre) {
  tbb::enumerable_thread_specific<int> values(-1);
  runTasks(16, [&](int turn) {
    values.local() = turn;
    const bool isSame = work_.doesTheSame(turn);
    failures_ += isSame && values.local() == turn ? 0 : 1;
  });
  EXPECT_EQ(failures_, 0);
}

TEST_P(InsideTbb, ABuildInsideACancelledGroupOfTheCallerIsFinished) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);
  tbb::task_arena arena(GetParam());
  arena.execute([&] {
    tbb::task_group group;
    group.run_and_wait([&] {
      group.cancel();
      for (const std::uint32_t threadCount : {0u, 1u, 2u})
        failures_ += work_.buildsTheSame(threadCount) ? 0 : 1;
    });
  });
  EXPECT_EQ(failures_, 0);
}

INSTANTIATE_TEST_SUITE_P(Threads, InsideTbb, testing::Values(1, 2, 8),
                         testing::PrintToStringParamName());

TEST(InsideTbbOfOneThread, AllIsAsOutside) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 1);
  for (int turn = 0; turn < 4; ++turn)
    EXPECT_TRUE(libraryWork().doesTheSame(turn)) << turn;
  std::atomic<int> failures = 0;
  tbb::parallel_for(0, 4, [&](int turn) { failures += libraryWork().doesTheSame(turn) ? 0 : 1; });
  EXPECT_EQ(failures, 0);
}

/// Triangles whose boxes are as small as denormal numbers are, beside others.
TriangleMesh<float> tinyTriangles() {
  return detail::scaled(detail::soup<float>(903, 20'000, 0.02), 0x1p-126f);
}

// A caller may have switched denormals off in one thread; then all threads build so.
TEST(BuildWithDenormalsFlushed, IsTheSameForAnyNumberOfThreads) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);
  const TriangleMesh<float> mesh = tinyTriangles();
  // A first build, so that oneTBB has seen threads that do not flush.
  static_cast<void>(buildTree(mesh.view(), {.threadCount = 8}));
  const FlushToZero mode(true);
  const auto serial = buildTree(mesh.view(), {.threadCount = 1});
  for (const std::uint32_t threadCount : {2u, 8u}) {
    const auto parallel = buildTree(mesh.view(), {.threadCount = threadCount});
    ASSERT_EQ(parallel.nodes().size(), serial.nodes().size());
    EXPECT_EQ(
        std::memcmp(parallel.nodes().data(), serial.nodes().data(), serial.nodes().size_bytes()),
        0);
  }
}

}  // namespace
}  // namespace planetree::test
