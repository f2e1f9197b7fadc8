#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace planetree::detail {

/// What changes when somebody writes to a file. Compared before and after a file is read, it tells
/// that what was read may be neither the older file nor the newer one, which no parser can tell: an
/// OBJ file that is cut off at the end of a line is an OBJ file.
///
/// Systems keep the time in steps of some milliseconds: changes that keep the size, and come right
/// behind each other, go unnoticed.
struct FileState {
  std::uint64_t size = 0;
  std::int64_t seconds = 0;  ///< when it was last written to
  std::int64_t nanoseconds = 0;

  friend bool operator==(const FileState&, const FileState&) = default;
};

/// Nothing for what is no regular file: a pipe has no state.
[[nodiscard]] std::optional<FileState> stateOf(int file) noexcept;
[[nodiscard]] std::optional<FileState> stateOf(std::FILE* file) noexcept;
[[nodiscard]] std::optional<FileState> stateOf(const std::filesystem::path& path) noexcept;

/// What is said of a file that has changed, and what to do.
inline constexpr const char* kChangedProblem = "it was changed while it was being read";
inline constexpr const char* kChangedAdvice =
    "Wait until the program that writes it is done, and try again";

}  // namespace planetree::detail
