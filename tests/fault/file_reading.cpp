#include "file_reading.hpp"

#include <cstddef>
#include <cstdio>
#include <utility>

// See memory_faults.cpp.
std::size_t realFread(void* bytes, std::size_t size, std::size_t count,
                      std::FILE* file) __asm__("__real_fread");
std::size_t wrappedFread(void* bytes, std::size_t size, std::size_t count,
                         std::FILE* file) __asm__("__wrap_fread");

namespace {

std::function<void()> workBeforeReading;

}  // namespace

std::size_t wrappedFread(void* bytes, std::size_t size, std::size_t count, std::FILE* file) {
  if (const auto work = std::exchange(workBeforeReading, {}))
    work();
  return realFread(bytes, size, count, file);
}

namespace planetree::test {

BeforeReading::BeforeReading(std::function<void()> work) {
  workBeforeReading = std::move(work);
}

BeforeReading::~BeforeReading() {
  workBeforeReading = {};
}

}  // namespace planetree::test
