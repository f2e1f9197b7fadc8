#pragma once

#include <filesystem>
#include <string>

namespace planetree::bench {

/// All of a file. Throws `Error` with `FileNotReadable`.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& file);

/// Throws `Error` with `FileNotWritable` if the file certainly cannot be written: to be asked
/// before an hour of measuring.
void checkIsWritable(const std::filesystem::path& file);

/// Writes the file under a temporary name and renames it when it is complete: under its own name is
/// either what was there before or all of the text. Throws `Error` with `FileNotWritable`.
void writeWholeFile(const std::filesystem::path& file, const std::string& bytes);

}  // namespace planetree::bench
