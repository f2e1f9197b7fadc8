#include "file_reading.hpp"

#include <cstddef>
#include <cstdio>
#include <utility>

// See memory_faults.cpp.
std::size_t realFread(void* bytes, std::size_t size, std::size_t count,
                      std::FILE* file) __asm__("__real_fread");
std::size_t wrappedFread(void* bytes, std::size_t size, std::size_t count,
                         std::FILE* file) __asm__("__wrap_fread");

// What the compiler calls instead where the sizes of buffers are checked.
std::size_t realCheckedFread(void* bytes, std::size_t room, std::size_t size, std::size_t count,
                             std::FILE* file) __asm__("__real___fread_chk");
std::size_t wrappedCheckedFread(void* bytes, std::size_t room, std::size_t size, std::size_t count,
                                std::FILE* file) __asm__("__wrap___fread_chk");

namespace {

std::function<void()> workBeforeReading;

void doWork() {
  if (const auto work = std::exchange(workBeforeReading, {}))
    work();
}

}  // namespace

std::size_t wrappedFread(void* bytes, std::size_t size, std::size_t count, std::FILE* file) {
  doWork();
  return realFread(bytes, size, count, file);
}

std::size_t wrappedCheckedFread(void* bytes, std::size_t room, std::size_t size, std::size_t count,
                                std::FILE* file) {
  doWork();
  return realCheckedFread(bytes, room, size, count, file);
}

namespace planetree::test {

BeforeReading::BeforeReading(std::function<void()> work) {
  workBeforeReading = std::move(work);
}

BeforeReading::~BeforeReading() {
  workBeforeReading = {};
}

}  // namespace planetree::test
