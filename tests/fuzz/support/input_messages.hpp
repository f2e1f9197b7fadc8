#pragma once

#include "import/message.hpp"

#include "support/byte_stream.hpp"

#include <cstddef>
#include <vector>

namespace planetree::fuzz {

/// What a reading process may say if it has gone mad. The first byte of an input says whether the
/// greeting is part of the input or goes without saying.
[[nodiscard]] inline std::vector<std::byte> messagesOf(ByteStream input) {
  std::vector<std::byte> bytes;
  if (input.takeByte() != 0) {
    for (const char character : importing::kGreeting)
      bytes.push_back(static_cast<std::byte>(character));
  }
  for (const std::byte byte : input.rest())
    bytes.push_back(byte);
  return bytes;
}

}  // namespace planetree::fuzz
