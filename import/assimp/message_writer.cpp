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

Payload& Payload::addText(std::string_view text) {
  constexpr std::size_t kLongest = 1000;
  addBytes(bytesOf(text.substr(0, kLongest)));
  return *this;
}

void Payload::addBytes(std::span<const std::byte> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

MessageWriter::MessageWriter(int pipe) : pipe_(pipe) {
  writeAll(bytesOf(kGreeting));
}

void MessageWriter::say(MessageKind kind, std::string_view text) {
  say(kind, Payload().addText(text));
}

void MessageWriter::sayFailure(FailureKind kind, std::string_view text) {
  say(MessageKind::Failure, Payload().add(kind).addText(text));
}

void MessageWriter::sayUnread(std::uint64_t count) {
  say(MessageKind::Unread, Payload().add(count));
}

void MessageWriter::append(MessageKind kind, std::span<const std::byte> bytes) {
  if (pendingKind_ != kind || pending_.size() + bytes.size() > kMaxMessageSize)
    flush();
  pendingKind_ = kind;
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
