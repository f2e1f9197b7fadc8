#pragma once

#include <planetree/error.hpp>
#include <planetree/mesh/read_mesh.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace planetree::test {

/// The bytes of a number in a byte order.
template <class Number>
std::string bytesOf(Number number, std::endian order = std::endian::little) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (order != std::endian::native)
    std::reverse(bytes.begin(), bytes.end());
  return {bytes.begin(), bytes.end()};
}

template <std::floating_point T>
TriangleMesh<T> readText(std::string_view text, MeshReadReport* report = nullptr,
                         const std::string& name = "model") {
  return readMesh<T>(std::as_bytes(std::span(text)), name, report);
}

/// The error that reading throws; a failure if it throws none.
inline std::optional<Error> errorOf(std::string_view text, const std::string& name = "model") {
  try {
    static_cast<void>(readText<float>(text, nullptr, name));
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return std::nullopt;
}

/// Expects a malformed file, a line (or `Error::kNone`), and words of the message.
inline void expectMalformed(std::string_view text, std::int64_t line, const std::string& words) {
  const std::optional<Error> error = errorOf(text);
  if (!error)
    return;
  const std::string message = error->what();
  EXPECT_EQ(error->code(), ErrorCode::MalformedFile) << message;
  EXPECT_EQ(error->line(), line) << message;
  EXPECT_EQ(error->file(), "model") << message;
  EXPECT_FALSE(error->advice().empty()) << message;
  EXPECT_NE(message.find(words), std::string::npos) << message;
}

}  // namespace planetree::test
