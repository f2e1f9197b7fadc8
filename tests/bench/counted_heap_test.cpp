#include "bench/support/counted_heap.hpp"

#include <gtest/gtest.h>

#include <malloc.h>
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <thread>
#include <vector>

namespace planetree::bench {
namespace {

constexpr std::size_t kSize = 10'000;
/// What an allocator may add to a block, for its alignment and to round its size up.
constexpr std::int64_t kRounding = 192;

/// Keeps the compiler from leaving out a block that nobody reads.
void use(void* block) {
  asm volatile("" : : "r"(block) : "memory");
}

class CountedHeap : public testing::Test {
 protected:
  void SetUp() override {
    if (!heapIsCounted())
      GTEST_SKIP() << "this build does not count memory";
  }

  /// A block of `kSize` bytes is counted when it is taken, and no longer when it is given back.
  template <class Take, class Give>
  static void expectCounted(const Take& take, const Give& giveBack) {
    const HeapCount count;
    auto* const block = take();
    use(block);
    EXPECT_GE(count.bytes(), static_cast<std::int64_t>(kSize));
    EXPECT_LE(count.bytes(), static_cast<std::int64_t>(kSize) + kRounding);
    giveBack(block);
    EXPECT_EQ(count.bytes(), 0);
  }
};

TEST_F(CountedHeap, SeesMallocAndItsKin) {
  const auto giveBack = [](void* block) { std::free(block); };
  expectCounted([] { return std::malloc(kSize); }, giveBack);
  expectCounted([] { return std::calloc(kSize / 10, 10); }, giveBack);
  expectCounted([] { return std::realloc(nullptr, kSize); }, giveBack);
  expectCounted([] { return std::aligned_alloc(64, kSize / 64 * 64 + 64); }, giveBack);
  expectCounted([] { return ::memalign(64, kSize); }, giveBack);
  expectCounted(
      [] {
        void* block = nullptr;
        EXPECT_EQ(::posix_memalign(&block, 64, kSize), 0);
        return block;
      },
      giveBack);
}

TEST_F(CountedHeap, SeesNew) {
  expectCounted([] { return new std::byte[kSize]; }, [](std::byte* block) { delete[] block; });
  struct alignas(64) Aligned {
    std::byte bytes[kSize / 64 * 64 + 64];
  };
  expectCounted([] { return new Aligned; }, [](Aligned* block) { delete block; });
}

TEST_F(CountedHeap, FollowsRealloc) {
  const HeapCount count;
  void* block = std::malloc(100);
  use(block);
  block = std::realloc(block, kSize);
  use(block);
  EXPECT_GE(count.bytes(), static_cast<std::int64_t>(kSize));
  EXPECT_LE(count.bytes(), static_cast<std::int64_t>(kSize) + kRounding);
  std::free(block);
  EXPECT_EQ(count.bytes(), 0);
}

TEST_F(CountedHeap, SeesMappedMemoryInWholePages) {
  const HeapCount count;
  constexpr std::size_t kMapped = (1u << 20) + 1;
  void* const block =
      ::mmap(nullptr, kMapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(block, MAP_FAILED);
  EXPECT_GT(count.bytes(), 1 << 20);
  EXPECT_LE(count.bytes(), (1 << 20) + (1 << 16));
  EXPECT_EQ(::munmap(block, kMapped), 0);
  EXPECT_EQ(count.bytes(), 0);
}

/// Maps memory and gives back its two ends, as whoever wants an aligned part of it does.
std::byte* mapAndCut(std::size_t mapped, std::size_t before, std::size_t after) {
  void* const all =
      ::mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  EXPECT_NE(all, MAP_FAILED);
  auto* const begin = static_cast<std::byte*>(all);
  EXPECT_EQ(::munmap(begin, before), 0);
  EXPECT_EQ(::munmap(begin + mapped - after, after), 0);
  return begin + before;
}

TEST_F(CountedHeap, ThePeakIsTheMostThatWasHeldAtATime) {
  const HeapCount count;
  EXPECT_EQ(count.peakBytes(), 0);
  for (int i = 0; i < 3; ++i) {
    void* const one = std::malloc(kSize);
    use(one);
    void* const two = std::malloc(kSize);
    use(two);
    std::free(one);
    std::free(two);
  }
  EXPECT_EQ(count.bytes(), 0);
  EXPECT_GE(count.peakBytes(), static_cast<std::int64_t>(2 * kSize));
  EXPECT_LE(count.peakBytes(), static_cast<std::int64_t>(2 * kSize) + 2 * kRounding);
  EXPECT_EQ(HeapCount().peakBytes(), 0) << "it begins anew each time";
}

TEST_F(CountedHeap, ThePeakHasMappedMemoryThatIsGivenBackAsAWhole) {
  constexpr std::size_t kMapped = 1u << 20;
  const HeapCount count;
  EXPECT_EQ(::munmap(mapAndCut(2 * kMapped, kMapped / 2, kMapped / 2), kMapped), 0);
  EXPECT_EQ(count.bytes(), 0);
  EXPECT_EQ(count.peakBytes(), static_cast<std::int64_t>(kMapped));
}

TEST_F(CountedHeap, ThePeakIsWithoutWhatIsCutOffAtOnce) {
  constexpr std::size_t kMapped = 1u << 20;
  const HeapCount count;
  std::byte* const kept = mapAndCut(2 * kMapped, kMapped / 4, 3 * kMapped / 4);
  EXPECT_EQ(count.peakBytes(), static_cast<std::int64_t>(kMapped));
  void* const block = std::malloc(kSize);
  use(block);
  EXPECT_LE(count.peakBytes(), static_cast<std::int64_t>(kMapped + kSize) + kRounding);
  // Now it has been used, and cutting it down does not undo that.
  EXPECT_EQ(::munmap(kept, kMapped / 2), 0);
  EXPECT_GE(count.peakBytes(), static_cast<std::int64_t>(kMapped + kSize));
  std::free(block);
  EXPECT_EQ(::munmap(kept + kMapped / 2, kMapped / 2), 0);
  EXPECT_EQ(count.bytes(), 0);
}

TEST_F(CountedHeap, SeesAllThreads) {
  // glibc gives a thread its stack from somewhere else, but the thread's arena is made on the heap.
  std::thread([] { std::free(std::malloc(kSize)); }).join();
  const HeapCount count;
  void* block = nullptr;
  std::thread([&] { block = std::malloc(kSize); }).join();
  EXPECT_GE(count.bytes(), static_cast<std::int64_t>(kSize));
  EXPECT_LE(count.bytes(), static_cast<std::int64_t>(kSize) + 4096);
  std::free(block);
}

TEST_F(CountedHeap, BeginsAnewEachTime) {
  auto kept = std::make_unique<std::byte[]>(kSize);
  use(kept.get());
  {
    const HeapCount count;
    EXPECT_EQ(count.bytes(), 0);
    kept.reset();
    EXPECT_LT(count.bytes(), 0);
  }
  EXPECT_EQ(HeapCount().bytes(), 0);
}

TEST_F(CountedHeap, RefusesAlignmentsThatPosixRefuses) {
  void* block = nullptr;
  EXPECT_NE(::posix_memalign(&block, 3, kSize), 0);
  EXPECT_NE(::posix_memalign(&block, 1, kSize), 0);
}

}  // namespace
}  // namespace planetree::bench
