#include "support/large_pages.hpp"

#include <new>
#include <utility>

#if defined(__linux__)
#include <sys/mman.h>
#include <cstdint>
#endif

namespace planetree::detail {
namespace {

#if defined(__linux__)

constexpr std::size_t kSmallPage = std::size_t{1} << 12u;
constexpr std::size_t kLargePage = std::size_t{1} << 21u;

constexpr std::size_t roundedUp(std::size_t size, std::size_t step) {
  return (size + step - 1) / step * step;
}

/// As much memory as is worth mapping: the last large page as a whole if little of it is wasted.
std::size_t worthMapping(std::size_t size) {
  const std::size_t whole = roundedUp(size, kLargePage);
  return whole - size <= size / 8 ? whole : roundedUp(size, kSmallPage);
}

/// Memory that begins where a large page may; null if there is none.
std::byte* map(std::size_t size) noexcept {
  void* const mapped =
      mmap(nullptr, size + kLargePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED)
    return nullptr;
  auto* const begin = static_cast<std::byte*>(mapped);
  const std::size_t before = roundedUp(reinterpret_cast<std::uintptr_t>(begin), kLargePage) -
                             reinterpret_cast<std::uintptr_t>(begin);
  if (before > 0)
    munmap(begin, before);
  if (before < kLargePage)
    munmap(begin + before + size, kLargePage - before);
  // No more than a wish, for the large pages that are filled: if it fails, all are small.
  static_cast<void>(madvise(begin + before, size / kLargePage * kLargePage, MADV_HUGEPAGE));
  return begin + before;
}

#endif

}  // namespace

LargePages::LargePages(std::size_t size) {
#if defined(__linux__)
  const std::size_t mappedSize = worthMapping(size);
  if (mappedSize >= kLargePage) {
    data_ = map(mappedSize);
    if (data_ != nullptr) {
      mappedSize_ = mappedSize;
      return;
    }
  }
#endif
  data_ = static_cast<std::byte*>(::operator new (size, std::align_val_t{kAlignment}));
}

LargePages::~LargePages() {
#if defined(__linux__)
  if (mappedSize_ > 0) {
    munmap(data_, mappedSize_);
    return;
  }
#endif
  ::operator delete (data_, std::align_val_t{kAlignment});
}

void LargePages::swap(LargePages& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(mappedSize_, other.mappedSize_);
}

}  // namespace planetree::detail
