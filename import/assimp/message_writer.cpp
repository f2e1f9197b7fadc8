#include "import/assimp/message_writer.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>

namespace planetree::importing {
namespace {

template <class Number>
std::span<const std::byte> bytesOf(const Number& number) noexcept {
  return std::as_bytes(std::span(&number, 1));
}

std::span<const std::byte> bytesOf(std::string_view text) noexcept {
  return std::as_bytes(std::span(text));
}

}  // namespace

MessageWriter::MessageWriter(int pipe) : pipe_(pipe) {
  writeAll(bytesOf(kGreeting));
}

void MessageWriter::say(MessageKind kind, std::string_view text) {
  constexpr std::size_t kLongest = 1000;
  write(kind, bytesOf(text.substr(0, kLongest)));
}

void MessageWriter::sayFailure(FailureKind kind, std::string_view text) {
  constexpr std::size_t kLongest = 1000;
  std::vector<std::byte> payload;
  const std::span<const std::byte> first = bytesOf(kind);
  const std::span<const std::byte> second = bytesOf(text.substr(0, kLongest));
  payload.insert(payload.end(), first.begin(), first.end());
  payload.insert(payload.end(), second.begin(), second.end());
  write(MessageKind::Failure, payload);
}

void MessageWriter::sayUnread(std::uint64_t count) {
  write(MessageKind::Unread, bytesOf(count));
}

void MessageWriter::addVertex(double x, double y, double z) {
  append(MessageKind::Vertices, x);
  append(MessageKind::Vertices, y);
  append(MessageKind::Vertices, z);
  // Only whole vertices may stand in a message.
  if (pending_.size() + 3 * sizeof(double) > kMaxMessageSize)
    flush();
}

void MessageWriter::addPolygonWord(std::uint32_t word) {
  append(MessageKind::Polygons, word);
  if (pending_.size() + sizeof(word) > kMaxMessageSize)
    flush();
}

template <class Number>
void MessageWriter::append(MessageKind kind, Number number) {
  if (pendingKind_ != kind)
    flush();
  pendingKind_ = kind;
  const std::span<const std::byte> bytes = bytesOf(number);
  pending_.insert(pending_.end(), bytes.begin(), bytes.end());
}

void MessageWriter::flush() {
  if (pending_.empty())
    return;
  std::vector<std::byte> payload;
  payload.swap(pending_);
  write(pendingKind_, payload);
  payload.clear();
  payload.swap(pending_);
}

void MessageWriter::write(MessageKind kind, std::span<const std::byte> payload) {
  flush();
  const MessageHeader header{.kind = kind, .size = static_cast<std::uint32_t>(payload.size())};
  writeAll(bytesOf(header));
  writeAll(payload);
}

void MessageWriter::writeAll(std::span<const std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::write(pipe_, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR)
      std::_Exit(EXIT_FAILURE);
    if (count > 0)
      bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

}  // namespace planetree::importing
