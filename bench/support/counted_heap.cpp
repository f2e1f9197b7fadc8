#include "bench/support/counted_heap.hpp"

#include <algorithm>
#include <atomic>

#ifdef PLANETREE_BENCH_COUNTS_HEAP
#include <malloc.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#endif

namespace planetree::bench {

namespace {

std::atomic<bool> isCounting = false;
std::atomic<std::int64_t> heldBytes = 0;
/// But for memory that was just mapped: it may still be cut down.
std::atomic<std::int64_t> mostBytes = 0;

}  // namespace

bool heapIsCounted() noexcept {
#ifdef PLANETREE_BENCH_COUNTS_HEAP
  return true;
#else
  return false;
#endif
}

HeapCount::HeapCount() noexcept {
  heldBytes = 0;
  mostBytes = 0;
  isCounting = true;
}

HeapCount::~HeapCount() {
  isCounting = false;
}

std::int64_t HeapCount::bytes() const noexcept {
  return heldBytes;
}

std::int64_t HeapCount::peakBytes() const noexcept {
  return std::max(mostBytes.load(), heldBytes.load());
}

#ifdef PLANETREE_BENCH_COUNTS_HEAP
namespace {

void raiseMost(std::int64_t bytes) noexcept {
  std::int64_t most = mostBytes.load(std::memory_order_relaxed);
  while (bytes > most && !mostBytes.compare_exchange_weak(most, bytes, std::memory_order_relaxed)) {
  }
}

/// Raises the peak by what is held now: after memory is taken, and before any is given back, which
/// ends the wait of what was just mapped.
void add(std::int64_t bytes) noexcept {
  if (!isCounting.load(std::memory_order_relaxed))
    return;
  const std::int64_t before = heldBytes.fetch_add(bytes, std::memory_order_relaxed);
  raiseMost(std::max(before, before + bytes));
}

/// The same for memory that may be cut down, or that is what is cut off: not seen by the peak.
void addUnseen(std::int64_t bytes) noexcept {
  if (isCounting.load(std::memory_order_relaxed))
    heldBytes.fetch_add(bytes, std::memory_order_relaxed);
}

std::int64_t usableBytes(void* block) noexcept {
  return static_cast<std::int64_t>(::malloc_usable_size(block));
}

void* taken(void* block) noexcept {
  if (block != nullptr && isCounting.load(std::memory_order_relaxed))
    add(usableBytes(block));
  return block;
}

void givenBack(void* block) noexcept {
  if (block != nullptr && isCounting.load(std::memory_order_relaxed))
    add(-usableBytes(block));
}

std::int64_t wholePages(std::size_t bytes) noexcept {
  static const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  return static_cast<std::int64_t>((bytes + page - 1) / page * page);
}

/// What this thread mapped last, as far as it is still there.
struct Mapping {
  std::uintptr_t begin = 0;
  std::uintptr_t end = 0;

  /// Whether the pages are one end of it, but not the whole, in which case they are cut off.
  bool loses(std::uintptr_t from, std::uintptr_t to) noexcept {
    if (from == begin && to < end)
      begin = to;
    else if (to == end && from > begin)
      end = from;
    else
      return false;
    return true;
  }
};
thread_local constinit Mapping lastMapping;

}  // namespace
#endif

}  // namespace planetree::bench

#ifdef PLANETREE_BENCH_COUNTS_HEAP

// The names under which glibc keeps its own functions for programs that replace them: "Replacing
// malloc" in its manual.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
}

// Symbols of a program reach its shared libraries only if they are visible. The compiler knows what
// malloc does and could call what is being defined: none of these calls another of them.
#define PLANETREE_BENCH_HOOK extern "C" [[gnu::visibility("default")]]

PLANETREE_BENCH_HOOK void* malloc(std::size_t size) noexcept {
  return planetree::bench::taken(__libc_malloc(size));
}

PLANETREE_BENCH_HOOK void* calloc(std::size_t count, std::size_t size) noexcept {
  return planetree::bench::taken(__libc_calloc(count, size));
}

PLANETREE_BENCH_HOOK void* realloc(void* block, std::size_t size) noexcept {
  if (!planetree::bench::isCounting.load(std::memory_order_relaxed))
    return __libc_realloc(block, size);
  const std::int64_t before = block != nullptr ? planetree::bench::usableBytes(block) : 0;
  void* const grown = __libc_realloc(block, size);
  if (grown != nullptr)
    planetree::bench::add(planetree::bench::usableBytes(grown) - before);
  else if (size == 0)
    planetree::bench::add(-before);
  return grown;
}

PLANETREE_BENCH_HOOK void free(void* block) noexcept {
  planetree::bench::givenBack(block);
  __libc_free(block);
}

PLANETREE_BENCH_HOOK void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return planetree::bench::taken(__libc_memalign(alignment, size));
}

PLANETREE_BENCH_HOOK void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return planetree::bench::taken(__libc_memalign(alignment, size));
}

PLANETREE_BENCH_HOOK int posix_memalign(void** block, std::size_t alignment,
                                        std::size_t size) noexcept {
  if (alignment % sizeof(void*) != 0 || alignment == 0 || (alignment & (alignment - 1)) != 0)
    return EINVAL;
  void* const found = __libc_memalign(alignment, size);
  if (found == nullptr)
    return ENOMEM;
  *block = planetree::bench::taken(found);
  return 0;
}

PLANETREE_BENCH_HOOK void* mmap(void* address, std::size_t size, int protection, int flags,
                                int file, off_t offset) noexcept {
  const long result = ::syscall(SYS_mmap, address, size, protection, flags, file, offset);
  if (result != -1 && (flags & MAP_ANONYMOUS) != 0) {
    const std::int64_t bytes = planetree::bench::wholePages(size);
    const auto begin = static_cast<std::uintptr_t>(result);
    planetree::bench::lastMapping = {begin, begin + static_cast<std::uintptr_t>(bytes)};
    planetree::bench::addUnseen(bytes);
  }
  return reinterpret_cast<void*>(result);
}

PLANETREE_BENCH_HOOK void* mmap64(void* address, std::size_t size, int protection, int flags,
                                  int file, off64_t offset) noexcept {
  static_assert(sizeof(off64_t) == sizeof(off_t), "on 32 bits the two take different offsets");
  return mmap(address, size, protection, flags, file, offset);
}

PLANETREE_BENCH_HOOK int munmap(void* address, std::size_t size) noexcept {
  const long result = ::syscall(SYS_munmap, address, size);
  if (result == 0) {
    const std::int64_t bytes = planetree::bench::wholePages(size);
    const auto begin = reinterpret_cast<std::uintptr_t>(address);
    if (planetree::bench::lastMapping.loses(begin, begin + static_cast<std::uintptr_t>(bytes)))
      planetree::bench::addUnseen(-bytes);
    else
      planetree::bench::add(-bytes);
  }
  return static_cast<int>(result);
}

#endif
