#include "ray_files/byte_source.hpp"

#include <planetree/error.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace planetree::tool {

namespace {

[[noreturn]] void fail(const std::string& name, int errorNumber) {
  const bool isMissing = errorNumber == ENOENT || errorNumber == ENOTDIR;
  throw Error(ErrorCode::FileNotReadable,
              "cannot be read (" + std::generic_category().message(errorNumber) + ")",
              isMissing ? "Check the spelling and the folder you are in."
                        : "Give a file with rays, or - for standard input.",
              {.file = name});
}

FileDescriptor open(const std::filesystem::path& path, const std::string& name) {
  FileDescriptor file(path == kStandardInput ? ::dup(STDIN_FILENO)
                                             : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0)
    fail(name, errno);
  return file;
}

/// The bytes between where a file stands and its end.
std::optional<std::uint64_t> remainingSize(const FileDescriptor& file) noexcept {
  struct stat status = {};
  if (!file.isRegularFile() || ::fstat(file.number(), &status) != 0)
    return std::nullopt;
  const off_t start = std::max<off_t>(::lseek(file.number(), 0, SEEK_CUR), 0);
  return static_cast<std::uint64_t>(std::max<off_t>(status.st_size - start, 0));
}

}  // namespace

ByteSource::ByteSource(const std::filesystem::path& path)
    : name_(path == kStandardInput ? "standard input" : path.string()),
      file_(open(path, name_)),
      state_(detail::stateOf(file_.number())),
      size_(remainingSize(file_)) {}

std::string_view ByteSource::peek(std::size_t count) {
  const KeepsGoing always = [] { return true; };
  while (peeked_.size() < count && readFromFile(peeked_, count - peeked_.size(), always)) {
  }
  return std::string_view(peeked_).substr(0, count);
}

std::string ByteSource::take(std::size_t count) {
  std::string bytes(peek(count));
  peeked_.erase(0, bytes.size());
  position_ += bytes.size();
  return bytes;
}

bool ByteSource::read(std::string& bytes, std::size_t most, const KeepsGoing& keepsGoing) {
  if (peeked_.empty()) {
    const std::size_t before = bytes.size();
    const bool hasMore = readFromFile(bytes, most, keepsGoing);
    position_ += bytes.size() - before;
    return hasMore;
  }
  const std::size_t count = std::min(most, peeked_.size());
  bytes.append(peeked_, 0, count);
  peeked_.erase(0, count);
  position_ += count;
  return true;
}

bool ByteSource::readFromFile(std::string& bytes, std::size_t most, const KeepsGoing& keepsGoing) {
  const std::size_t before = bytes.size();
  while (file_.waitToRead(keepsGoing)) {
    bytes.resize(before + most);
    const ssize_t count = ::read(file_.number(), bytes.data() + before, most);
    bytes.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count > 0)
      return true;
    if (count == 0) {
      requireSame();
      return false;
    }
    if (errno != EINTR)
      fail(name_, errno);
  }
  return false;
}

void ByteSource::requireSame() const {
  if (detail::stateOf(file_.number()) != state_) {
    throw Error(ErrorCode::FileNotReadable, detail::kChangedProblem, detail::kChangedAdvice,
                {.file = name_});
  }
}

bool ByteSource::isReady() const noexcept {
  return !peeked_.empty() || file_.isReadyToRead();
}

}  // namespace planetree::tool
