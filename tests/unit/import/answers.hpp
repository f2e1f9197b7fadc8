#pragma once

#include "import/message.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <string>

/// What a program that reads may answer, message by message.
namespace planetree::test {

using importing::FailureKind;
using importing::kGreeting;
using importing::MessageKind;

template <class Number>
std::string bytesOf(Number number) {
  const auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  return {bytes.begin(), bytes.end()};
}

inline std::string message(MessageKind kind, const std::string& payload = "") {
  return bytesOf(kind) + bytesOf(static_cast<std::uint32_t>(payload.size())) + payload;
}

inline std::string vertices(std::initializer_list<double> coordinates) {
  std::string payload;
  for (const double coordinate : coordinates)
    payload += bytesOf(coordinate);
  return message(MessageKind::Vertices, payload);
}

inline std::string polygons(std::initializer_list<std::uint32_t> words) {
  std::string payload;
  for (const std::uint32_t word : words)
    payload += bytesOf(word);
  return message(MessageKind::Polygons, payload);
}

inline std::string failure(FailureKind kind, const std::string& text) {
  return message(MessageKind::Failure, bytesOf(kind) + text);
}

inline const std::string kStart = std::string(kGreeting) + message(MessageKind::Mesh);
inline const std::string kTriangle = vertices({0, 0, 0, 1, 0, 0, 0, 1, 0});
inline const std::string kEnd = message(MessageKind::End);

}  // namespace planetree::test
