#pragma once

#include "support/promise.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace planetree::fuzz {

/// A file that is nowhere but in memory, for readers that want one.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const std::byte> bytes) : number_(::memfd_create("input", 0)) {
    const auto size = static_cast<ssize_t>(bytes.size());
    if (number_ < 0 || ::write(number_, bytes.data(), bytes.size()) != size ||
        ::lseek(number_, 0, SEEK_SET) != 0)
      reportBroken("there is memory for an input");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(number_); }

  /// Its descriptor, which stands at the first byte.
  [[nodiscard]] int number() const noexcept { return number_; }
  /// A name by which it can be opened.
  [[nodiscard]] std::filesystem::path path() const {
    return "/proc/self/fd/" + std::to_string(number_);
  }

 private:
  int number_;
};

}  // namespace planetree::fuzz
