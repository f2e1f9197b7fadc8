#pragma once

#include "import/message.hpp"

#include <chrono>
#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace planetree::importing {

/// Thrown where the other side breaks the rules of message.hpp.
class BrokenMessages : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown where the other side ends before it has told all.
class MessagesEnd : public std::runtime_error {
 public:
  MessagesEnd() : std::runtime_error("the messages end too early") {}
};

/// Thrown where the other side takes too long.
class DeadlinePassed : public std::runtime_error {
 public:
  DeadlinePassed() : std::runtime_error("no answer in time") {}
};

/// A message as it came; the payload is good until the next one is read.
struct Message {
  MessageKind kind = MessageKind::End;
  std::span<const std::byte> payload;

  /// The payload as text.
  [[nodiscard]] std::string text() const {
    return {reinterpret_cast<const char*>(payload.data()), payload.size()};
  }

  /// Takes a number off the front of the payload. Throws `BrokenMessages` if there are not enough
  /// bytes.
  template <class Number>
  [[nodiscard]] Number take() {
    static_assert(std::is_arithmetic_v<Number>);
    Number number;
    if (payload.size() < sizeof(Number))
      throw BrokenMessages("a message is too short");
    std::memcpy(&number, payload.data(), sizeof(Number));
    payload = payload.subspan(sizeof(Number));
    return number;
  }
};

/// Reads messages from a pipe, waiting for each until the deadline. The memory that it takes is
/// bounded by the size of one message, whatever is promised.
class MessageReader {
 public:
  using Clock = std::chrono::steady_clock;

  MessageReader(int pipe, Clock::time_point deadline) : pipe_(pipe), deadline_(deadline) {}

  /// The next message. Throws `BrokenMessages`, `MessagesEnd` and `DeadlinePassed`.
  [[nodiscard]] Message next();

 private:
  void greet();
  void readExactly(std::span<std::byte> bytes);
  void waitForBytes() const;

  int pipe_;
  Clock::time_point deadline_;
  bool isGreeted_ = false;
  std::vector<std::byte> payload_;
};

}  // namespace planetree::importing
