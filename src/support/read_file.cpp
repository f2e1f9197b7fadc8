#include "support/read_file.hpp"

#include <planetree/error.hpp>

#include "support/file_state.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <system_error>

namespace planetree::detail {
namespace {

struct FileCloser {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};
using FileHandle = std::unique_ptr<std::FILE, FileCloser>;

Error notReadable(const std::filesystem::path& path, int reason) {
  const auto error = [&](const std::string& problem, const std::string& advice) {
    return Error(ErrorCode::FileNotReadable, problem, advice, Error::Place{path.string()});
  };
  switch (reason) {
    case ENOENT:
    case ENOTDIR:
      return error("there is no such file", "Check the spelling and the folder you are in");
    case EISDIR:
      return error("it is a folder, not a file", "Name a file in it");
    case EACCES:
      return error("there is no permission to read it",
                   "Change its permissions or those of its folder");
    default:
      return error("it cannot be read: " + std::generic_category().message(reason),
                   "Check that other programs can read it");
  }
}

FileHandle openFile(const std::filesystem::path& path) {
  // Some systems open a folder like a file and fail later, or not at all.
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw notReadable(path, EISDIR);
  FileHandle file(std::fopen(path.string().c_str(), "rb"));
  if (!file)
    throw notReadable(path, errno);
  return file;
}

/// What to allocate at first: one byte more than the file has, so that its end shows at once.
std::size_t firstCapacity(const std::filesystem::path& path) {
  constexpr std::size_t kUnknownSize = std::size_t{64} * 1024;
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed))
    return kUnknownSize;
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  return failed ? kUnknownSize : std::max(static_cast<std::size_t>(size) + 1, kUnknownSize);
}

/// A terminal is read to its end, but a device like /dev/zero has none.
constexpr std::size_t kMostOfDevice = std::size_t{64} * 1024 * 1024;

Error endlessDevice(const std::filesystem::path& path) {
  return {ErrorCode::FileNotReadable, "it is a device that gives 64 MiB or more",
          "Copy what is wanted of it into a file", Error::Place{path.string()}};
}

void requireSame(const std::optional<FileState>& before, const FileHandle& file,
                 const std::filesystem::path& path) {
  if (stateOf(file.get()) != before) {
    throw Error(ErrorCode::FileNotReadable, kChangedProblem, kChangedAdvice,
                Error::Place{path.string()});
  }
}

}  // namespace

void requireReadable(const std::filesystem::path& path) {
  // Opening a pipe would wait for its writer, and take what it writes away.
  std::error_code failed;
  if (std::filesystem::is_fifo(path, failed))
    return;
  static_cast<void>(openFile(path));
}

void refuseDeviceOrPipe(const std::filesystem::path& path, const std::string& advice) {
  std::error_code ignored;
  if (std::filesystem::is_other(std::filesystem::status(path, ignored))) {
    throw Error(ErrorCode::FileNotReadable, "it is a device or a pipe, not a file", advice,
                Error::Place{path.string()});
  }
}

FileContent readFile(const std::filesystem::path& path) {
  const FileHandle file = openFile(path);
  const std::optional<FileState> before = stateOf(file.get());
  std::error_code ignored;
  const bool isDevice = std::filesystem::is_character_file(path, ignored);
  std::size_t capacity = firstCapacity(path);
  std::size_t size = 0;
  auto bytes = std::make_unique_for_overwrite<std::byte[]>(capacity);
  while (true) {
    errno = 0;
    size += std::fread(bytes.get() + size, 1, capacity - size, file.get());
    if (std::ferror(file.get()))
      throw notReadable(path, errno);
    if (size < capacity) {
      requireSame(before, file, path);
      return {std::move(bytes), size};
    }
    if (isDevice && size >= kMostOfDevice)
      throw endlessDevice(path);
    capacity *= 2;
    auto larger = std::make_unique_for_overwrite<std::byte[]>(capacity);
    std::copy_n(bytes.get(), size, larger.get());
    bytes = std::move(larger);
  }
}

}  // namespace planetree::detail
