#include "output_file.hpp"

#include <planetree/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <climits>
#include <string>
#include <system_error>
#include <utility>

namespace planetree::tool {

namespace fs = std::filesystem;

namespace {

std::string adviceFor(int errorNumber) {
  switch (errorNumber) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "Free some space there, or write elsewhere with -o.";
    case ENOENT:
    case ENOTDIR:
      return "Make the folder first, or write elsewhere with -o.";
    case EISDIR:
      return "Add a file name to the folder.";
    default:
      return "Write elsewhere with -o.";
  }
}

[[noreturn]] void fail(const fs::path& path, int errorNumber) {
  throw Error(ErrorCode::FileNotWritable,
              fmt::format("cannot be written ({})", std::generic_category().message(errorNumber)),
              adviceFor(errorNumber), {.file = path.string()});
}

/// Opens a file; an error names `named`, the file that the user asked for.
FileDescriptor openForWriting(const fs::path& path, int flags, const fs::path& named) {
  constexpr mode_t kEveryoneButUmask = 0666;
  const int number = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, kEveryoneButUmask);
  if (number < 0)
    fail(named, errno);
  return FileDescriptor(number);
}

fs::path shownName(const fs::path& path) {
  return path == kStandardOutput ? fs::path("standard output") : path;
}

fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// A name beside `target` that is free: a program that was killed may have left its temporary file,
/// and process numbers come again.
fs::path unusedPathBeside(const fs::path& target) {
  for (int attempt = 0;; ++attempt) {
    fs::path path = folderOf(target) / fmt::format(".planetree-{}-{}.tmp", ::getpid(), attempt);
    if (!fs::exists(fs::symlink_status(path)))
      return path;
  }
}

/// A device or a pipe: something that a rename would destroy.
bool isSpecialFile(const fs::path& path) {
  const fs::file_status status = fs::status(path);
  return fs::exists(status) && !fs::is_regular_file(status);
}

/// The file that will be replaced: where a symbolic link leads, even to nothing yet, so that the
/// link stays one. The system refuses chains that are longer than this one follows.
fs::path replacedPath(fs::path path) {
  constexpr int kMaxLinks = 40;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(path); ++i) {
    path = folderOf(path) / fs::read_symlink(path);
  }
  return path;
}

/// Where the next byte goes, or a negative number if one cannot go back there: in a pipe, or where
/// the system appends whatever is written.
off_t startOf(const FileDescriptor& file) noexcept {
  const int flags = ::fcntl(file.number(), F_GETFL);
  const bool isAppending = flags >= 0 && (flags & O_APPEND) != 0;
  return isAppending ? -1 : ::lseek(file.number(), 0, SEEK_CUR);
}

void checkPath(const fs::path& path) {
  if (fs::is_directory(path))
    fail(path, EISDIR);
  if (isSpecialFile(path)) {
    if (::access(path.c_str(), W_OK) != 0)
      fail(path, errno);
    return;
  }
  const fs::path folder = folderOf(replacedPath(path));
  if (::access(folder.c_str(), W_OK) != 0)
    fail(path, errno);
  if (!fs::is_directory(folder))
    fail(path, ENOTDIR);
}

}  // namespace

std::string lowerCaseExtension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void checkIsWritable(const fs::path& path) try {
  if (path != kStandardOutput)
    checkPath(path);
} catch (const fs::filesystem_error& error) {
  fail(path, error.code().value());
}

bool canOverwriteStart(const fs::path& path) {
  if (path == kStandardOutput)
    return startOf(FileDescriptor(::dup(STDOUT_FILENO))) >= 0;
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return !fs::is_fifo(status) && !fs::is_socket(status);
}

bool writeFile(const fs::path& path, std::span<const std::byte> bytes,
               const std::function<bool()>& isWanted) {
  if (!isWanted())
    return false;
  OutputFile file(path, isWanted);
  return file.write(bytes) && file.complete();
}

/// How a file is written: under a temporary name, or directly.
struct OutputFile::Place {
  fs::path temporary;
  fs::path target;
  FileDescriptor file;

  static Place standardOutput() {
    FileDescriptor file(::dup(STDOUT_FILENO));
    if (file.number() < 0)
      fail(shownName(kStandardOutput), errno);
    return {.temporary = {}, .target = {}, .file = std::move(file)};
  }

  static Place of(const fs::path& path) try {
    if (path == kStandardOutput)
      return standardOutput();
    if (isSpecialFile(path))
      return {.temporary = {}, .target = path, .file = openForWriting(path, 0, path)};
    const fs::path target = replacedPath(path);
    const fs::path temporary = unusedPathBeside(target);
    return {.temporary = temporary,
            .target = target,
            .file = openForWriting(temporary, O_CREAT | O_EXCL, path)};
  } catch (const fs::filesystem_error& error) {
    fail(path, error.code().value());
  }
};

OutputFile::OutputFile(fs::path path, std::function<bool()> isWanted)
    : OutputFile(path, std::move(isWanted), Place::of(path)) {}

OutputFile::OutputFile(fs::path path, std::function<bool()> isWanted, Place place)
    : path_(shownName(path)),
      isWanted_(std::move(isWanted)),
      temporary_(std::move(place.temporary)),
      target_(std::move(place.target)),
      file_(std::move(place.file)),
      start_(startOf(file_)) {}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!temporary_.empty())
    fs::remove(temporary_, ignored);
}

bool OutputFile::write(std::span<const std::byte> bytes) {
  const bool mayBlock = !file_.isRegularFile();
  while (!bytes.empty()) {
    if (mayBlock && !file_.waitToWrite(isWanted_))
      return false;
    // A pipe that is ready takes this much at once, without making its writer wait.
    const std::size_t most = mayBlock ? std::size_t{PIPE_BUF} : bytes.size();
    const ssize_t count = ::write(file_.number(), bytes.data(), std::min(bytes.size(), most));
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      fail(path_, errno);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

void OutputFile::overwriteStart(std::span<const std::byte> bytes) {
  off_t offset = start_;
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(file_.number(), bytes.data(), bytes.size(), offset);
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      fail(path_, errno);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
    offset += count;
  }
}

bool OutputFile::complete() try {
  if (!file_.close())
    fail(path_, errno);
  if (temporary_.empty())
    return true;
  if (!isWanted_())
    return false;
  fs::rename(temporary_, target_);
  temporary_.clear();
  return true;
} catch (const fs::filesystem_error& error) {
  fail(path_, error.code().value());
}

}  // namespace planetree::tool
