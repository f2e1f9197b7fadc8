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
#include <optional>
#include <thread>
#include <utility>
#include <vector>

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
  // A cancelled group swallows what is thrown in it: only what is built counts.
  int builtCount = 0;
  arena.execute([&] {
    tbb::task_group group;
    group.run_and_wait([&] {
      group.cancel();
      for (const std::uint32_t threadCount : {0u, 1u, 2u})
        builtCount += work_.buildsTheSame(threadCount) ? 1 : 0;
    });
  });
  EXPECT_EQ(builtCount, 3);
}

INSTANTIATE_TEST_SUITE_P(Threads, InsideTbb, testing::Values(1, 2, 8),
                         testing::PrintToStringParamName());

/// Work of the library that is slow on all threads but the one that asked for it: this one has done
/// its part early, and waits. Knows when a thread is inside of it.
class WaitingWork {
 public:
  /// A box that takes its time.
  struct SlowBox {
    using Scalar = float;
    Box3 box;
    const WaitingWork* work = nullptr;

    [[nodiscard]] Box3 bounds() const {
      work->waitIfElsewhere();
      return box;
    }
    [[nodiscard]] std::optional<Hitf> intersect(const Rayf&, float, float) const noexcept {
      return std::nullopt;
    }
  };

  explicit WaitingWork(std::thread::id caller = std::this_thread::get_id()) : caller_(caller) {}

  static bool isInside() noexcept { return isInside_; }

  void build(std::uint32_t threadCount) const {
    std::vector<SlowBox> boxes(20'000);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const float position = static_cast<float>(i) / 16.0f;
      // One in each of the portions that threads take.
      boxes[i] = {{{position, 0, 0}, {position + 1, 1, 1}}, i % 512 == 0 ? this : &quick()};
    }
    isInside_ = true;
    static_cast<void>(buildTree(std::move(boxes), {.threadCount = threadCount}));
    isInside_ = false;
  }

  void trace(std::uint32_t threadCount) const {
    const LibraryWork& work = libraryWork();
    std::vector<Hitf> hits(work.rays().size());
    const HitFilter filter(
        [](const Hitf& hit, void* context) noexcept {
          if (hit.primitive % 8 == 0)
            static_cast<const WaitingWork*>(context)->waitIfElsewhere();
          return true;
        },
        const_cast<WaitingWork*>(this));
    isInside_ = true;
    static_cast<void>(work.tree().findIntersections(
        work.rays(), hits, {.query = {.filter = filter}, .threadCount = threadCount}));
    isInside_ = false;
  }

 private:
  static const WaitingWork& quick() {
    static const WaitingWork work(std::thread::id{});
    return work;
  }

  void waitIfElsewhere() const noexcept {
    if (caller_ != std::thread::id{} && std::this_thread::get_id() != caller_)
      std::this_thread::sleep_for(50us);
  }

  static inline thread_local bool isInside_ = false;

  std::thread::id caller_;
};

/// How many tasks of the caller begin on a thread that is inside of `work(turn)`, which is run
/// again and again while another thread has tasks for whoever asks.
template <class Work>
int intrusionsInto(int turnCount, const Work& work) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);
  tbb::task_arena arena(8);
  std::atomic<int> intrusions = 0;
  std::atomic<int> waitingTasks = 0;
  std::atomic<bool> isOver = false;
  arena.execute([&] {
    tbb::task_group tasks;
    tasks.run([&] {
      tbb::task_group others;
      while (!isOver) {
        if (waitingTasks >= 20) {
          std::this_thread::yield();
          continue;
        }
        ++waitingTasks;
        others.run([&] {
          --waitingTasks;
          intrusions += WaitingWork::isInside() ? 1 : 0;
          std::this_thread::sleep_for(100us);
        });
      }
      others.wait();
    });
    while (waitingTasks == 0)
      std::this_thread::yield();
    for (int turn = 0; turn < turnCount; ++turn)
      work(turn);
    isOver = true;
    tasks.wait();
  });
  return intrusions;
}

// Who holds a lock, or a value of their thread, while the library waits for other threads must not
// find another of their tasks on the same thread.
TEST(InsideBusyTbb, NoTaskOfTheCallerBeginsInsideOfABuild) {
  const auto build = [](int turn) { WaitingWork().build(static_cast<std::uint32_t>(turn % 4)); };
  EXPECT_EQ(intrusionsInto(12, build), 0);
}

// With a number of threads of its own a batch has a place of its own; without, that of the caller.
TEST(InsideBusyTbb, NoTaskOfTheCallerBeginsInsideOfABatch) {
  const auto trace = [](int turn) { WaitingWork().trace(turn % 8 == 7 ? 2 : 0); };
  EXPECT_EQ(intrusionsInto(160, trace), 0);
}

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
