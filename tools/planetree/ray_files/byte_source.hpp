#pragma once

#include "file_descriptor.hpp"

#include "support/file_state.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace planetree::tool {

/// The name that stands for standard input.
inline constexpr const char* kStandardInput = "-";

/// Asked again and again; once it answers no, work stops.
using KeepsGoing = std::function<bool()>;

/// The bytes of a file, or of standard input, in their order. Every function throws `Error` with
/// `FileNotReadable`, at the end also if the file was written to since it was opened.
class ByteSource {
 public:
  explicit ByteSource(const std::filesystem::path& path);

  /// What errors call it.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

  /// How many bytes there are in all; nothing for a pipe or a terminal.
  [[nodiscard]] std::optional<std::uint64_t> size() const noexcept { return size_; }
  /// How many of them were read.
  [[nodiscard]] std::uint64_t position() const noexcept { return position_; }

  /// The next bytes, which stay to be read: `count` of them, or fewer where the source ends.
  [[nodiscard]] std::string_view peek(std::size_t count);

  /// Reads them: `count` bytes, or fewer where the source ends.
  [[nodiscard]] std::string take(std::size_t count);

  /// Appends as many bytes as there are, up to `most`, which is not zero. Waits for the first one.
  /// False if there are no more, or if `keepsGoing` said no.
  [[nodiscard]] bool read(std::string& bytes, std::size_t most, const KeepsGoing& keepsGoing);

  /// Whether `read` would return at once.
  [[nodiscard]] bool isReady() const noexcept;

 private:
  void requireSame() const;
  bool readFromFile(std::string& bytes, std::size_t most, const KeepsGoing& keepsGoing);

  std::string name_;
  FileDescriptor file_;
  std::optional<detail::FileState> state_;  ///< of a regular file, when it was opened
  std::optional<std::uint64_t> size_;
  std::uint64_t position_ = 0;
  std::string peeked_;
};

}  // namespace planetree::tool
