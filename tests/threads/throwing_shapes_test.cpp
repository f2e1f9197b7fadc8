#include <planetree/planetree.hpp>

#include <gtest/gtest.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

/// What shapes of a program throw while a tree is built, on whatever thread.
namespace planetree::test {
namespace {

struct TooManyCalls : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How often members of shapes are called, and at which call they throw; counted for one build.
struct CallCounter {
  std::atomic<std::int64_t> calls = 0;
  std::int64_t lastCall = -1;  ///< the one that throws; none if negative
  int number = 0;              ///< goes into the exception

  void count() {
    if (calls++ == lastCall)
      throw TooManyCalls(std::to_string(number));
  }
};

/// A box that throws at some call, and counts those who hold it.
struct CountedShape {
  using Scalar = float;
  Box3 box;
  std::shared_ptr<CallCounter> counter;

  [[nodiscard]] Box3 bounds() const {
    counter->count();
    return box;
  }
  [[nodiscard]] Box3 clippedBounds(const Box3& cell) const {
    counter->count();
    return intersection(box, cell);
  }
  [[nodiscard]] std::optional<Hitf> intersect(const Rayf&, float, float) const noexcept {
    return std::nullopt;
  }
};

/// Enough for several threads, and to be clipped.
std::vector<CountedShape> shapesWith(const std::shared_ptr<CallCounter>& counter) {
  std::vector<CountedShape> shapes(10'000);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const float position = static_cast<float>(i) / 16.0f;
    shapes[i] = {{{position, 0, 0}, {position + 1, 1, 1}}, counter};
  }
  return shapes;
}

std::int64_t callsOfABuild() {
  const auto counter = std::make_shared<CallCounter>();
  static_cast<void>(buildTree(shapesWith(counter), {.threadCount = 1}));
  return counter->calls;
}

/// Builds, and returns the number that came with the exception; nothing if there was none.
std::optional<std::string> numberThrown(const std::shared_ptr<CallCounter>& counter,
                                        std::uint32_t threadCount) {
  try {
    static_cast<void>(buildTree(shapesWith(counter), {.threadCount = threadCount}));
    return std::nullopt;
  } catch (const TooManyCalls& error) {
    return error.what();
  }
}

TEST(ThrowingShapes, EndTheBuildAtAnyCallAndNothingIsLeftOfIt) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);
  const std::int64_t callCount = callsOfABuild();
  ASSERT_GT(callCount, 20'000) << "they should be clipped, too";
  for (const std::uint32_t threadCount : {1u, 2u, 8u}) {
    for (std::int64_t i = 0; i < 12; ++i) {
      const auto counter = std::make_shared<CallCounter>();
      counter->lastCall = i * (callCount - 1) / 11;
      counter->number = 7;
      EXPECT_EQ(numberThrown(counter, threadCount), "7")
          << "call " << counter->lastCall << " of " << callCount << ", " << threadCount;
      EXPECT_EQ(counter.use_count(), 1) << "shapes are left over";
    }
  }
}

TEST(ThrowingShapes, EndTheirOwnBuildAndNoOther) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);
  const std::int64_t callCount = callsOfABuild();
  std::atomic<int> failures = 0;
  const auto buildOne = [&](int i) {
    const auto counter = std::make_shared<CallCounter>();
    counter->number = i;
    if (i % 3 != 0)
      counter->lastCall = (i + 1) * (callCount / 20);
    const auto number = numberThrown(counter, static_cast<std::uint32_t>(i % 4));
    const std::optional<std::string> expected =
        i % 3 != 0 ? std::optional(std::to_string(i)) : std::nullopt;
    failures += number == expected && counter.use_count() == 1 ? 0 : 1;
  };
  tbb::parallel_for(0, 12, buildOne);
  EXPECT_EQ(failures, 0);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back(buildOne, i);
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(failures, 0);
}

// An exception that goes through a loop of the caller ends the loop, as without the library.
TEST(ThrowingShapes, MayThrowThroughALoopOfTheCaller) {
  const auto counter = std::make_shared<CallCounter>();
  counter->lastCall = 15'000;
  EXPECT_THROW(
      tbb::parallel_for(0, 4,
                        [&](int i) {
                          static_cast<void>(buildTree(
                              shapesWith(counter), {.threadCount = static_cast<std::uint32_t>(i)}));
                        }),
      TooManyCalls);
  EXPECT_EQ(counter.use_count(), 1);
}

// `intersect` runs inside of queries that are `noexcept`: a class without the word is no shape.
struct ShapeThatMayThrow {
  using Scalar = float;
  [[nodiscard]] Box3 bounds() const { return {}; }
  [[nodiscard]] std::optional<Hitf> intersect(const Rayf&, float, float) const {
    return std::nullopt;
  }
};
static_assert(!Shape<ShapeThatMayThrow> && Shape<CountedShape>);

}  // namespace
}  // namespace planetree::test
