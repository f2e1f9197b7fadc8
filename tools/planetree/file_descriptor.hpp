#pragma once

#include <functional>

namespace planetree::tool {

/// An open file that closes itself.
class FileDescriptor {
 public:
  /// Takes the number, which is negative if opening failed.
  explicit FileDescriptor(int number) noexcept : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept;
  FileDescriptor& operator=(FileDescriptor&&) = delete;
  ~FileDescriptor();

  [[nodiscard]] int number() const noexcept { return number_; }
  [[nodiscard]] bool isRegularFile() const noexcept;

  /// Waits until reading a little will not block; false if `isWanted` said no first, which it is
  /// asked again and again.
  [[nodiscard]] bool waitToRead(const std::function<bool()>& isWanted) const;
  /// Whether reading a little would not block now.
  [[nodiscard]] bool isReadyToRead() const noexcept;

  /// Whether closing succeeded: some file systems report a full disk only then.
  [[nodiscard]] bool close() noexcept;

 private:
  int number_;
};

}  // namespace planetree::tool
