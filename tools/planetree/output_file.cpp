#include "output_file.hpp"

#include <planetree/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
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

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) noexcept : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0)
      ::close(number_);
  }

  [[nodiscard]] int number() const noexcept { return number_; }

  /// Whether closing succeeded: some file systems report a full disk only then.
  [[nodiscard]] bool close() noexcept { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

/// Opens a file; an error names `named`, the file that the user asked for.
Descriptor openForWriting(const fs::path& path, int flags, const fs::path& named) {
  constexpr mode_t kEveryoneButUmask = 0666;
  const int number = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, kEveryoneButUmask);
  if (number < 0)
    fail(named, errno);
  return Descriptor(number);
}

void writeAll(const Descriptor& file, std::span<const std::byte> bytes, const fs::path& named) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file.number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      fail(named, errno);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
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

/// A new file beside `target`, removed again unless it is renamed to it.
class TemporaryFile {
 public:
  TemporaryFile(const fs::path& target, const fs::path& named)
      : path_(unusedPathBeside(target)), file_(openForWriting(path_, O_CREAT | O_EXCL, named)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    if (!path_.empty())
      fs::remove(path_, ignored);
  }

  [[nodiscard]] Descriptor& file() noexcept { return file_; }

  void renameTo(const fs::path& target) {
    fs::rename(path_, target);
    path_.clear();
  }

 private:
  fs::path path_;
  Descriptor file_;
};

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

void writeDirectly(const fs::path& path, std::span<const std::byte> bytes) {
  Descriptor file = openForWriting(path, 0, path);
  writeAll(file, bytes, path);
  if (!file.close())
    fail(path, errno);
}

void writeStandardOutput(std::span<const std::byte> bytes) {
  const fs::path named = "standard output";
  Descriptor file(::dup(STDOUT_FILENO));
  if (file.number() < 0)
    fail(named, errno);
  writeAll(file, bytes, named);
  if (!file.close())
    fail(named, errno);
}

bool writeBesideAndRename(const fs::path& path, std::span<const std::byte> bytes,
                          const std::function<bool()>& isWanted) {
  const fs::path target = replacedPath(path);
  TemporaryFile temporary(target, path);
  writeAll(temporary.file(), bytes, path);
  if (!temporary.file().close())
    fail(path, errno);
  if (!isWanted())
    return false;
  temporary.renameTo(target);
  return true;
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

void checkIsWritable(const fs::path& path) try {
  if (path != kStandardOutput)
    checkPath(path);
} catch (const fs::filesystem_error& error) {
  fail(path, error.code().value());
}

bool writeFile(const fs::path& path, std::span<const std::byte> bytes,
               const std::function<bool()>& isWanted) try {
  const bool isStandardOutput = path == kStandardOutput;
  if (!isStandardOutput && !isSpecialFile(path))
    return writeBesideAndRename(path, bytes, isWanted);
  if (!isWanted())
    return false;
  if (isStandardOutput) {
    writeStandardOutput(bytes);
  } else {
    writeDirectly(path, bytes);
  }
  return true;
} catch (const fs::filesystem_error& error) {
  fail(path, error.code().value());
}

}  // namespace planetree::tool
