#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>

/// Writing results to a file or to standard output.
///
/// A regular file is written under a temporary name beside the final one and renamed when it is
/// complete: under the final name there is either the old file or the whole new one, and after a
/// failure nothing is left behind. Devices and pipes are written directly.
namespace planetree::tool {

/// The name that stands for standard output.
inline constexpr const char* kStandardOutput = "-";

/// Throws `Error` with `FileNotWritable` if the file certainly cannot be written later. To be asked
/// before long work; it changes nothing.
void checkIsWritable(const std::filesystem::path& path);

/// Writes all bytes. `isWanted` is asked once more just before the file appears under its name; if
/// it answers no, nothing is left. Returns whether the file was written. Throws `Error` with
/// `FileNotWritable`.
bool writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes,
               const std::function<bool()>& isWanted);

}  // namespace planetree::tool
