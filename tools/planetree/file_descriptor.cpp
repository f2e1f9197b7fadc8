#include "file_descriptor.hpp"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <utility>

namespace planetree::tool {

namespace {

constexpr int kMillisecondsBetweenQuestions = 100;

/// Anything but a time-out counts as ready: an error shows in the call that is waited for.
bool isReadable(int number, int milliseconds) noexcept {
  pollfd waited{.fd = number, .events = POLLIN, .revents = 0};
  return ::poll(&waited, 1, milliseconds) > 0;
}

}  // namespace

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept
    : number_(std::exchange(other.number_, -1)) {}

FileDescriptor::~FileDescriptor() {
  if (number_ >= 0)
    ::close(number_);
}

bool FileDescriptor::isRegularFile() const noexcept {
  struct stat status = {};
  return ::fstat(number_, &status) == 0 && S_ISREG(status.st_mode);
}

bool FileDescriptor::waitToRead(const std::function<bool()>& isWanted) const {
  while (isWanted()) {
    if (isReadable(number_, kMillisecondsBetweenQuestions))
      return true;
  }
  return false;
}

bool FileDescriptor::isReadyToRead() const noexcept {
  return isReadable(number_, 0);
}

bool FileDescriptor::close() noexcept {
  return ::close(std::exchange(number_, -1)) == 0;
}

}  // namespace planetree::tool
