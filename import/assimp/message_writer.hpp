#pragma once

#include "import/message.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace planetree::importing {

/// The bytes of a message of several parts.
class Payload {
 public:
  template <class Number>
  Payload& add(Number number) {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    addBytes(std::as_bytes(std::span(&number, 1)));
    return *this;
  }
  template <class Number, std::size_t kCount>
  Payload& add(const std::array<Number, kCount>& numbers) {
    for (const Number number : numbers)
      add(number);
    return *this;
  }
  /// The last part. A text that is too long is cut.
  Payload& addText(std::string_view text);

  [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return bytes_; }

 private:
  void addBytes(std::span<const std::byte> bytes);

  std::vector<std::byte> bytes_;
};

/// Writes messages into a pipe. If nobody reads them the process ends: nobody waits for it.
class MessageWriter {
 public:
  explicit MessageWriter(int pipe);

  void say(MessageKind kind) { write(kind, {}); }
  /// A text that is too long for a message is cut.
  void say(MessageKind kind, std::string_view text);
  void sayFailure(FailureKind kind, std::string_view text);
  void sayUnread(std::uint64_t count);
  void say(MessageKind kind, const Payload& payload) { write(kind, payload.bytes()); }

  /// Adds numbers that have to stand in one message, a vertex for instance.
  template <class Number, std::size_t kCount>
  void add(MessageKind kind, const std::array<Number, kCount>& numbers) {
    append(kind, std::as_bytes(std::span(numbers)));
  }
  void addVertex(double x, double y, double z) { add(MessageKind::Vertices, std::array{x, y, z}); }
  void addPolygonWord(std::uint32_t word) { add(MessageKind::Polygons, std::array{word}); }
  /// Sends the numbers that are still here.
  void flush();

 private:
  void write(MessageKind kind, std::span<const std::byte> payload);
  void writeAll(std::span<const std::byte> bytes) const;
  void append(MessageKind kind, std::span<const std::byte> bytes);

  int pipe_;
  MessageKind pendingKind_ = MessageKind::Vertices;
  std::vector<std::byte> pending_;
};

}  // namespace planetree::importing
