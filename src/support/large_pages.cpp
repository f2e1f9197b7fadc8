#include "support/large_pages.hpp"

#if defined(__linux__)
#include <sys/mman.h>
#include <cstdint>
#endif

namespace planetree::detail {

void adviseLargePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t size) noexcept {
#if defined(__linux__)
  // Only whole large pages: none is used up by more than the array.
  constexpr std::uintptr_t kLargePage = std::uintptr_t{1} << 21u;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + kLargePage - 1) / kLargePage * kLargePage;
  const std::uintptr_t last = (begin + size) / kLargePage * kLargePage;
  // No more than a wish: if it fails, pages are small.
  if (first < last)
    static_cast<void>(madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE));
#endif
}

}  // namespace planetree::detail
