#include "memory_faults.hpp"

#include <link.h>
#include <sys/mman.h>
#include <sys/types.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>

// What the linker's --wrap makes of a name: calls of it come to __wrap_NAME, and __real_NAME is the
// function itself.
void* realMalloc(std::size_t size) __asm__("__real_malloc");
void* realRealloc(void* block, std::size_t size) __asm__("__real_realloc");
void realFree(void* block) __asm__("__real_free");
void* realMmap(void* place, std::size_t size, int protection, int flags, int file,
               off_t offset) __asm__("__real_mmap");
int realMunmap(void* place, std::size_t size) __asm__("__real_munmap");

void* wrappedMalloc(std::size_t size) __asm__("__wrap_malloc");
void* wrappedRealloc(void* block, std::size_t size) __asm__("__wrap_realloc");
void wrappedFree(void* block) __asm__("__wrap_free");
void* wrappedMmap(void* place, std::size_t size, int protection, int flags, int file,
                  off_t offset) __asm__("__wrap_mmap");
int wrappedMunmap(void* place, std::size_t size) __asm__("__wrap_munmap");

namespace planetree::test {
namespace {

std::atomic<std::int64_t> blockCount = 0;
std::atomic<std::int64_t> mappedBytes = 0;

std::atomic<bool> isCounting = false;
std::atomic<std::uint64_t> requests = 0;
std::atomic<std::uint64_t> failures = 0;

// Written while nothing is counted.
FaultKind faultKind = FaultKind::None;
std::uint64_t firstFault = 0;
std::stop_source* stopSource = nullptr;

/// Where the code of oneTBB lies.
struct CodeRange {
  std::uintptr_t begin = 0;
  std::uintptr_t end = 0;
};
struct CodeRanges {
  std::array<CodeRange, 8> all;
  std::size_t count = 0;
};

int addIfTbb(dl_phdr_info* library, std::size_t /*size*/, void* data) {
  auto& ranges = *static_cast<CodeRanges*>(data);
  if (std::strstr(library->dlpi_name, "libtbb") == nullptr)
    return 0;
  for (std::size_t i = 0; i < library->dlpi_phnum && ranges.count < ranges.all.size(); ++i) {
    const auto& segment = library->dlpi_phdr[i];
    if (segment.p_type != PT_LOAD)
      continue;
    const std::uintptr_t begin = library->dlpi_addr + segment.p_vaddr;
    ranges.all[ranges.count++] = {begin, begin + segment.p_memsz};
  }
  return 0;
}

bool isOfTbb(const void* caller) noexcept {
  static const CodeRanges ranges = [] {
    CodeRanges found;
    ::dl_iterate_phdr(&addIfTbb, &found);
    return found;
  }();
  const auto address = reinterpret_cast<std::uintptr_t>(caller);
  return std::any_of(
      ranges.all.begin(), ranges.all.begin() + ranges.count,
      [&](const CodeRange& range) { return address >= range.begin && address < range.end; });
}

/// Counts a request, and says whether it may be met.
bool mayHaveMemory() noexcept {
  if (!isCounting)
    return true;
  const std::uint64_t number = ++requests;
  if (stopSource != nullptr && number == firstFault)
    stopSource->request_stop();
  const bool fails = (faultKind == FaultKind::One && number == firstFault) ||
                     (faultKind == FaultKind::FromThenOn && number >= firstFault);
  if (fails)
    ++failures;
  return !fails;
}

constexpr std::size_t kUsualAlignment = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

/// Null if there is none.
void* newBlock(std::size_t size, std::size_t alignment, const void* caller) noexcept {
  const bool isCounted = !isOfTbb(caller);
  if (isCounted && !mayHaveMemory())
    return nullptr;
  void* const block =
      alignment <= kUsualAlignment
          ? realMalloc(std::max<std::size_t>(size, 1))
          : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (block != nullptr && isCounted)
    ++blockCount;
  return block;
}

void* newBlockOrThrow(std::size_t size, std::size_t alignment, const void* caller) {
  void* const block = newBlock(size, alignment, caller);
  if (block == nullptr)
    throw std::bad_alloc();
  return block;
}

void deleteBlock(void* block, const void* caller) noexcept {
  if (block == nullptr)
    return;
  if (!isOfTbb(caller))
    --blockCount;
  realFree(block);
}

}  // namespace

HeldMemory heldMemory() noexcept {
  return {blockCount, mappedBytes};
}

MemoryFaults::MemoryFaults(FaultKind kind, std::uint64_t first) noexcept {
  faultKind = kind;
  firstFault = first;
  stopSource = nullptr;
  requests = 0;
  failures = 0;
  isCounting = true;
}

MemoryFaults::MemoryFaults(std::stop_source& source, std::uint64_t number) noexcept
    : MemoryFaults(FaultKind::None, number) {
  stopSource = &source;
}

void MemoryFaults::end() noexcept {
  isCounting = false;
}

std::uint64_t MemoryFaults::requestCount() noexcept {
  return requests;
}

std::uint64_t MemoryFaults::failedCount() noexcept {
  return failures;
}

}  // namespace planetree::test

using namespace planetree::test;

#define PLANETREE_CALLER __builtin_return_address(0)

void* operator new(std::size_t size) {
  return newBlockOrThrow(size, kUsualAlignment, PLANETREE_CALLER);
}
void* operator new[](std::size_t size) {
  return newBlockOrThrow(size, kUsualAlignment, PLANETREE_CALLER);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return newBlockOrThrow(size, static_cast<std::size_t>(alignment), PLANETREE_CALLER);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return newBlockOrThrow(size, static_cast<std::size_t>(alignment), PLANETREE_CALLER);
}
void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  return newBlock(size, kUsualAlignment, PLANETREE_CALLER);
}
void* operator new[](std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  return newBlock(size, kUsualAlignment, PLANETREE_CALLER);
}
void* operator new(std::size_t size, std::align_val_t alignment,
                   const std::nothrow_t& /*tag*/) noexcept {
  return newBlock(size, static_cast<std::size_t>(alignment), PLANETREE_CALLER);
}
void* operator new[](std::size_t size, std::align_val_t alignment,
                     const std::nothrow_t& /*tag*/) noexcept {
  return newBlock(size, static_cast<std::size_t>(alignment), PLANETREE_CALLER);
}

void operator delete(void* block) noexcept {
  deleteBlock(block, PLANETREE_CALLER);
}
void operator delete[](void* block) noexcept {
  deleteBlock(block, PLANETREE_CALLER);
}
void operator delete(void* block, std::size_t /*size*/) noexcept {
  deleteBlock(block, PLANETREE_CALLER);
}
void operator delete[](void* block, std::size_t /*size*/) noexcept {
  deleteBlock(block, PLANETREE_CALLER);
}
void operator delete(void* block, std::align_val_t /*alignment*/) noexcept {
  deleteBlock(block, PLANETREE_CALLER);
}
void operator delete[](void* block, std::align_val_t /*alignment*/) noexcept {
  deleteBlock(block, PLANETREE_CALLER);
}
void operator delete(void* block, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  deleteBlock(block, PLANETREE_CALLER);
}
void operator delete[](void* block, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  deleteBlock(block, PLANETREE_CALLER);
}
void operator delete(void* block, const std::nothrow_t& /*tag*/) noexcept {
  deleteBlock(block, PLANETREE_CALLER);
}
void operator delete[](void* block, const std::nothrow_t& /*tag*/) noexcept {
  deleteBlock(block, PLANETREE_CALLER);
}
void operator delete(void* block, std::align_val_t /*alignment*/,
                     const std::nothrow_t& /*tag*/) noexcept {
  deleteBlock(block, PLANETREE_CALLER);
}
void operator delete[](void* block, std::align_val_t /*alignment*/,
                       const std::nothrow_t& /*tag*/) noexcept {
  deleteBlock(block, PLANETREE_CALLER);
}

#undef PLANETREE_CALLER

void* wrappedMalloc(std::size_t size) {
  if (!mayHaveMemory())
    return nullptr;
  void* const block = realMalloc(size);
  blockCount += block != nullptr ? 1 : 0;
  return block;
}

void* wrappedRealloc(void* block, std::size_t size) {
  if (!mayHaveMemory())
    return nullptr;
  void* const moved = realRealloc(block, size);
  blockCount += block == nullptr && moved != nullptr ? 1 : 0;
  return moved;
}

void wrappedFree(void* block) {
  blockCount -= block != nullptr ? 1 : 0;
  realFree(block);
}

void* wrappedMmap(void* place, std::size_t size, int protection, int flags, int file,
                  off_t offset) {
  if (!mayHaveMemory()) {
    errno = ENOMEM;
    return MAP_FAILED;
  }
  void* const mapped = realMmap(place, size, protection, flags, file, offset);
  if (mapped != MAP_FAILED)
    mappedBytes += static_cast<std::int64_t>(size);
  return mapped;
}

int wrappedMunmap(void* place, std::size_t size) {
  const int result = realMunmap(place, size);
  if (result == 0)
    mappedBytes -= static_cast<std::int64_t>(size);
  return result;
}
