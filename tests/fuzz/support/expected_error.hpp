#pragma once

#include <planetree/error.hpp>

#include "support/promise.hpp"

#include <optional>
#include <string>

namespace planetree::fuzz {

/// What `read` makes of a file with this name; nothing if it refuses it as it should, with an
/// `Error` that names the file and gives advice. Anything else that it throws ends the program.
template <class Read>
auto readOrRefuse(const std::string& name, const Read& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const Error& error) {
    const auto details = [&error] { return std::string(error.what()); };
    require(error.file() == name, "an error names the file", details);
    require(!error.advice().empty(), "an error gives advice", details);
    require(error.code() == ErrorCode::MalformedFile || error.code() == ErrorCode::UnknownFormat,
            "bytes that cannot be read are malformed or unknown", details);
    return std::nullopt;
  }
}

}  // namespace planetree::fuzz
