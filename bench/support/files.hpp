#pragma once

#include <filesystem>
#include <string>

namespace planetree::bench {

/// All of a file. Throws `Error` with `FileNotReadable`.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& file);

/// The name that stands for standard output.
inline constexpr const char* kStandardOutput = "-";

/// Throws `Error` with `FileNotReadable` if the file certainly cannot be read. Reads nothing: what
/// is taken from a pipe is gone.
void checkIsReadable(const std::filesystem::path& file);

/// Throws `Error` with `FileNotWritable` if the file certainly cannot be written: to be asked
/// before an hour of measuring.
void checkIsWritable(const std::filesystem::path& file);

/// Whether what is written takes the place of what was there, so that a file may be written again
/// and again: not on standard output, nor in a pipe or on a device.
[[nodiscard]] bool isReplacedWhenWritten(const std::filesystem::path& file);

/// Writes the file under a temporary name and renames it when it is complete: under its own name is
/// either what was there before or all of the bytes. A symbolic link stays one. What
/// `isReplacedWhenWritten` excludes is written straight into. Throws `Error` with
/// `FileNotWritable`.
void writeWholeFile(const std::filesystem::path& file, const std::string& bytes);

/// Throws `Error` with `FileNotWritable` unless all that was printed has reached its place. To be
/// called last: the system may not tell sooner that a disk is full.
void finishStandardOutput();

}  // namespace planetree::bench
