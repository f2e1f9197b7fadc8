#include "support/memory_meter.hpp"

#include <planetree/error.hpp>

#include <limits>
#include <string>

#if defined(__linux__)
#include <unistd.h>
#endif

namespace planetree::detail {
namespace {

std::uint64_t memoryOfMachine() noexcept {
#if defined(__linux__)
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long pageSize = sysconf(_SC_PAGESIZE);
  if (pages > 0 && pageSize > 0)
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(pageSize);
#endif
  return std::numeric_limits<std::uint64_t>::max();
}

std::string megabytes(std::uint64_t bytes) {
  return std::to_string((bytes + 999'999) / 1'000'000) + " MB";
}

}  // namespace

MemoryMeter::MemoryMeter(std::uint64_t limit) : limit_(limit != 0 ? limit : memoryOfMachine()) {}

void MemoryMeter::add(std::size_t bytes) {
  const std::uint64_t now = current_ += bytes;
  if (now > limit_) {
    current_ -= bytes;
    throw Error(ErrorCode::MemoryLimitExceeded,
                "the build needs more than " + megabytes(limit_) + " of memory",
                "Raise the memory limit, lower referencesPerObject, build with the preset fast, or "
                "divide the scene into several trees.");
  }
  std::uint64_t peak = peak_;
  while (now > peak && !peak_.compare_exchange_weak(peak, now)) {
  }
}

void MemoryMeter::remove(std::size_t bytes) noexcept {
  current_ -= bytes;
}

}  // namespace planetree::detail
