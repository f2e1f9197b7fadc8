#pragma once

#include "import/message.hpp"

#include "support/byte_stream.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace planetree::fuzz {

/// What a reading process may say if it has gone mad. The first byte of an input says whether the
/// greeting is part of the input or goes without saying.
[[nodiscard]] inline std::vector<std::byte> messagesOf(ByteStream input) {
  std::vector<std::byte> bytes;
  if (input.takeByte() != 0) {
    const auto greeting = std::as_bytes(std::span(importing::kGreeting));
    bytes.assign(greeting.begin(), greeting.end());
  }
  bytes.insert(bytes.end(), input.rest().begin(), input.rest().end());
  return bytes;
}

}  // namespace planetree::fuzz
