#include "import/message_reader.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <limits>

namespace planetree::importing {

Message MessageReader::next() {
  greet();
  MessageHeader header;
  readExactly(std::as_writable_bytes(std::span(&header, 1)));
  if (header.kind > MessageKind::End)
    throw BrokenMessages("a message of unknown kind");
  if (header.size > kMaxMessageSize)
    throw BrokenMessages("a message is too long");
  payload_.resize(header.size);
  readExactly(payload_);
  return {header.kind, payload_};
}

void MessageReader::greet() {
  if (isGreeted_)
    return;
  std::array<char, kGreeting.size()> greeting;
  readExactly(std::as_writable_bytes(std::span(greeting)));
  if (std::string_view(greeting.data(), greeting.size()) != kGreeting)
    throw BrokenMessages("another greeting was expected");
  isGreeted_ = true;
}

void MessageReader::readExactly(std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    waitForBytes();
    const ssize_t count = ::read(pipe_, bytes.data(), bytes.size());
    if (count == 0)
      throw MessagesEnd();
    if (count < 0 && errno != EINTR)
      throw BrokenMessages("the messages cannot be read");
    if (count > 0)
      bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

void MessageReader::waitForBytes() const {
  using std::chrono::milliseconds;
  pollfd waiting = {.fd = pipe_, .events = POLLIN, .revents = 0};
  while (true) {
    constexpr milliseconds kLongest(std::numeric_limits<int>::max());
    const auto left = std::min(kLongest, std::chrono::ceil<milliseconds>(deadline_ - Clock::now()));
    if (left <= milliseconds(0))
      throw DeadlinePassed();
    const int ready = ::poll(&waiting, 1, static_cast<int>(left.count()));
    if (ready > 0)
      return;
    if (ready < 0 && errno != EINTR)
      throw BrokenMessages("the messages cannot be waited for");
  }
}

}  // namespace planetree::importing
