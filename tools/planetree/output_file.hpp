#pragma once

#include "file_descriptor.hpp"

#include <planetree/error.hpp>

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

/// Writing results to a file or to standard output.
///
/// A regular file is written under a temporary name beside the final one and renamed when it is
/// complete: under the final name there is either the old file or the whole new one, and after a
/// failure nothing is left behind. Devices and pipes are written directly; where nobody reads from
/// a pipe any more, `ReaderLeft` is thrown.
namespace planetree::tool {

/// The reader of a pipe has left before all was written: not a fault of anybody, as with `head`.
class ReaderLeft : public Error {
 public:
  using Error::Error;
};

/// The name that stands for standard output.
inline constexpr const char* kStandardOutput = "-";

/// What follows the last dot of a file name, with the dot, in lower case.
[[nodiscard]] std::string lowerCaseExtension(const std::filesystem::path& path);

/// Throws `Error` with `FileNotWritable` if the file certainly cannot be written later. To be asked
/// before long work; it changes nothing.
void checkIsWritable(const std::filesystem::path& path);

/// Whether `OutputFile::overwriteStart` will be possible: not in a pipe, nor where the system
/// appends whatever is written.
[[nodiscard]] bool canOverwriteStart(const std::filesystem::path& path);

/// Writes all bytes. Throws `Error` with `FileNotWritable`.
void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// A result that is written piece by piece. Unless it is completed, nothing is left of a regular
/// file, also if a signal ends the tool. There may be one at a time. Every function throws `Error`
/// with `FileNotWritable`.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Appends the bytes.
  void write(std::span<const std::byte> bytes);

  /// Replaces the first bytes that were written.
  void overwriteStart(std::span<const std::byte> bytes);

  /// Makes the file appear.
  void complete();

 private:
  std::filesystem::path path_;       ///< for errors
  std::filesystem::path target_;     ///< what appears; empty if it is written directly
  std::filesystem::path temporary_;  ///< what is written until then; likewise
  FileDescriptor file_;
  off_t start_ = 0;  ///< where the first byte stands; negative if nobody can go there again
};

}  // namespace planetree::tool
