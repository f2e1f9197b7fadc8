#include "file_descriptor.hpp"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <utility>

namespace planetree::tool {

namespace {

constexpr int kMillisecondsBetweenQuestions = 100;

/// Anything but a time-out counts as ready: an error shows in the call that is waited for.
bool isReady(int number, short event, int milliseconds) noexcept {
  pollfd waited{.fd = number, .events = event, .revents = 0};
  return ::poll(&waited, 1, milliseconds) > 0;
}

bool wait(int number, short event, const std::function<bool()>& isWanted) {
  while (isWanted()) {
    if (isReady(number, event, kMillisecondsBetweenQuestions))
      return true;
  }
  return false;
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
  return wait(number_, POLLIN, isWanted);
}

bool FileDescriptor::waitToWrite(const std::function<bool()>& isWanted) const {
  return wait(number_, POLLOUT, isWanted);
}

bool FileDescriptor::isReadyToRead() const noexcept {
  return isReady(number_, POLLIN, 0);
}

bool FileDescriptor::close() noexcept {
  return ::close(std::exchange(number_, -1)) == 0;
}

}  // namespace planetree::tool
