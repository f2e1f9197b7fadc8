#pragma once

#include <planetree/error.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace planetree::detail {

/// The bytes of a model file and the name it goes by in errors.
struct MeshInput {
  std::span<const std::byte> bytes;
  std::string name;

  /// An error with `MalformedFile`, to be thrown. `line` is that of a text format.
  [[nodiscard]] Error malformed(const std::string& problem, const std::string& advice,
                                std::int64_t line = Error::kNone) const;

  /// The error for a word where a coordinate should be.
  [[nodiscard]] Error notANumber(std::string_view word, std::int64_t line) const;

  /// The error for a word where a vertex index or a count should be.
  [[nodiscard]] Error notAnInteger(std::string_view word, std::int64_t line) const;
};

}  // namespace planetree::detail
