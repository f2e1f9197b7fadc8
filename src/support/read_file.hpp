#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace planetree::detail {

/// The content of a file, in memory of its own.
///
/// The file is read, not mapped: a mapped file that another program shortens meanwhile would stop
/// the process with a signal, and reading is a small part of the time that parsing takes.
class FileContent {
 public:
  FileContent(std::unique_ptr<std::byte[]> bytes, std::size_t size) noexcept
      : bytes_(std::move(bytes)), size_(size) {}

  [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t size_;
};

/// Throws `Error` with `FileNotReadable` if the file cannot be opened to read it.
void requireReadable(const std::filesystem::path& path);

/// Throws `Error` with `FileNotReadable` and this advice if it is a device or a pipe. For files
/// that another one names: a device may have no end, and opening a pipe may wait for ever.
void refuseDeviceOrPipe(const std::filesystem::path& path, const std::string& advice);

/// Reads a whole file; pipes are read to their end. Throws `Error` with `FileNotReadable`, also for
/// a file that is written to meanwhile.
[[nodiscard]] FileContent readFile(const std::filesystem::path& path);

}  // namespace planetree::detail
