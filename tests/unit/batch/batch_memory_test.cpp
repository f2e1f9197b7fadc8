#include <planetree/planetree.hpp>

#include "support/batch_rays.hpp"
#include "support/batch_scenes.hpp"

#include <gtest/gtest.h>

#include <malloc.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <span>
#include <vector>

namespace {

std::atomic<std::int64_t> heldBytes = 0;
std::atomic<std::int64_t> mostBytes = 0;

void* counted(void* block) {
  if (block == nullptr)
    throw std::bad_alloc();
  const std::int64_t held = heldBytes += static_cast<std::int64_t>(::malloc_usable_size(block));
  std::int64_t most = mostBytes;
  while (held > most && !mostBytes.compare_exchange_weak(most, held)) {
  }
  return block;
}

void giveBack(void* block) noexcept {
  heldBytes -= static_cast<std::int64_t>(::malloc_usable_size(block));
  std::free(block);
}

}  // namespace

// All other forms of `new` and `delete` call these.
void* operator new(std::size_t size) {
  return counted(std::malloc(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}
void operator delete(void* block) noexcept {
  giveBack(block);
}
void operator delete(void* block, std::size_t /*size*/) noexcept {
  giveBack(block);
}
void operator delete(void* block, std::align_val_t /*alignment*/) noexcept {
  giveBack(block);
}
void operator delete(void* block, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  giveBack(block);
}

namespace planetree {
namespace {

/// The most that is held while `work` runs, beside what was held before.
template <class Work>
std::int64_t mostHeldBy(const Work& work) {
  const std::int64_t before = heldBytes;
  mostBytes = before;
  work();
  return mostBytes - before;
}

TEST(BatchMemory, IsCountedByThisTest) {
  EXPECT_GE(
      mostHeldBy([] { std::vector<int>(10'000).swap(*std::make_unique<std::vector<int>>()); }),
      10'000);
  EXPECT_EQ(mostHeldBy([] {}), 0);
}

template <class T>
class BatchMemoryOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BatchMemoryOf, Scalars);

TYPED_TEST(BatchMemoryOf, ABatchDoesNotGrowWithItsRays) {
  using T = TypeParam;
  const auto tree = buildTree(test::room<T>());
  const test::PictureFrame<T> frame{{T(0.2), T(0.3), -1}, {1, 0, 0}, {0, 1, 0}};
  for (const auto& rays : {test::pinholePicture<T>({T(0.1), T(0.2), T(1.5)}, frame, 640, 250),
                           test::randomRays<T>(tree.bounds(), 160'000, 801)}) {
    std::vector<Hit<T>> hits(rays.size());
    std::vector<std::uint8_t> flags(rays.size());
    for (const std::uint32_t threadCount : {1u, 2u}) {
      const auto mostHeld = [&](std::size_t count) {
        const auto some = std::span<const Ray<T>>(rays).first(count);
        return mostHeldBy([&] {
          tree.findIntersections(some, std::span(hits).first(count), {.threadCount = threadCount});
          tree.areOccluded(some, std::span(flags).first(count), {.threadCount = threadCount});
        });
      };
      // What threads keep for themselves is taken once; and at any time they may be at work on
      // more portions, or on fewer.
      constexpr std::int64_t kOfThreads = 1 << 18;
      static_cast<void>(mostHeld(rays.size()));
      EXPECT_LE(mostHeld(rays.size()), mostHeld(10'000) + kOfThreads) << threadCount << " threads";
    }
  }
}

}  // namespace
}  // namespace planetree
