#pragma once

#include "import/message.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace planetree::importing {

/// Writes messages into a pipe. If nobody reads them the process ends: nobody waits for it.
class MessageWriter {
 public:
  explicit MessageWriter(int pipe);

  void say(MessageKind kind) { write(kind, {}); }
  /// A text that is too long for a message is cut.
  void say(MessageKind kind, std::string_view text);
  void sayFailure(FailureKind kind, std::string_view text);
  void sayUnread(std::uint64_t count);

  void addVertex(double x, double y, double z);
  void addPolygonWord(std::uint32_t word);
  /// Sends the vertices or words that are still here.
  void flush();

 private:
  void write(MessageKind kind, std::span<const std::byte> payload);
  void writeAll(std::span<const std::byte> bytes) const;
  template <class Number>
  void append(MessageKind kind, Number number);

  int pipe_;
  MessageKind pendingKind_ = MessageKind::Vertices;
  std::vector<std::byte> pending_;
};

}  // namespace planetree::importing
