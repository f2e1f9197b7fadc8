#include "output_file.hpp"

#include "interruption.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <string>
#include <system_error>

namespace planetree::tool {

namespace fs = std::filesystem;

namespace {

constexpr const char* kShownStandardOutput = "standard output";

std::string adviceFor(const fs::path& path, int errorNumber) {
  const std::string elsewhere =
      path == kShownStandardOutput ? "redirect it elsewhere." : "write elsewhere with -o.";
  switch (errorNumber) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "Free some space there, or " + elsewhere;
    case ENOENT:
    case ENOTDIR:
      return "Make the folder first, or " + elsewhere;
    case EISDIR:
      return "Add a file name to the folder.";
    default:
      return (path == kShownStandardOutput ? 'R' : 'W') + elsewhere.substr(1);
  }
}

[[noreturn]] void fail(const fs::path& path, int errorNumber) {
  const std::string problem =
      fmt::format("cannot be written ({})", std::generic_category().message(errorNumber));
  const Error::Place place{.file = path.string()};
  if (errorNumber == EPIPE)
    throw ReaderLeft(ErrorCode::FileNotWritable, problem, "Let its reader read to the end.", place);
  throw Error(ErrorCode::FileNotWritable, problem, adviceFor(path, errorNumber), place);
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
  return path == kStandardOutput ? fs::path(kShownStandardOutput) : path;
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

bool isWrittenDirectly(const fs::path& path) {
  return path == kStandardOutput || isSpecialFile(path);
}

FileDescriptor openDirectly(const fs::path& path) {
  if (path != kStandardOutput)
    return openForWriting(path, 0, path);
  FileDescriptor file(::dup(STDOUT_FILENO));
  if (file.number() < 0)
    fail(shownName(path), errno);
  return file;
}

/// Opens a new file that stands in for `named` for the time being.
FileDescriptor createTemporary(const fs::path& temporary, const fs::path& named) {
  const InterruptionPause pause;
  FileDescriptor file = openForWriting(temporary, O_CREAT | O_EXCL, named);
  removeOnInterruption(temporary.c_str());
  return file;
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

void writeFile(const fs::path& path, std::span<const std::byte> bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.complete();
}

OutputFile::OutputFile(const fs::path& path) try
    : path_(shownName(path)),
      target_(isWrittenDirectly(path) ? fs::path() : replacedPath(path)),
      temporary_(target_.empty() ? fs::path() : unusedPathBeside(target_)),
      file_(temporary_.empty() ? openDirectly(path) : createTemporary(temporary_, path)),
      start_(startOf(file_)) {
} catch (const fs::filesystem_error& error) {
  fail(path, error.code().value());
}

OutputFile::~OutputFile() {
  if (temporary_.empty())
    return;
  const InterruptionPause pause;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
  removeOnInterruption(nullptr);
}

void OutputFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file_.number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      fail(path_, errno);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
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

void OutputFile::complete() try {
  if (!file_.close())
    fail(path_, errno);
  if (temporary_.empty())
    return;
  const InterruptionPause pause;
  fs::rename(temporary_, target_);
  removeOnInterruption(nullptr);
  temporary_.clear();
} catch (const fs::filesystem_error& error) {
  fail(path_, error.code().value());
}

}  // namespace planetree::tool
