#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string_view>

namespace planetree::detail {

/// The value of a decimal number, rounded once to the nearest T; nothing if the word as a whole is
/// not a number. Independent of the locale. "inf" and "nan" are numbers; what lies outside the
/// range of T becomes infinity or zero.
template <std::floating_point T>
[[nodiscard]] std::optional<T> parseNumber(std::string_view word) noexcept;

/// True if `number` is the infinite value of a word that is finite itself.
template <std::floating_point T>
[[nodiscard]] bool isTooLarge(std::string_view word, T number) noexcept {
  return std::isinf(number) && word.find_first_of("0123456789") != std::string_view::npos;
}

/// The value of a decimal integer; nothing if the word as a whole is not one. What lies outside the
/// range becomes the nearest end of it.
[[nodiscard]] std::optional<std::int64_t> parseInteger(std::string_view word) noexcept;

extern template std::optional<float> parseNumber<float>(std::string_view) noexcept;
extern template std::optional<double> parseNumber<double>(std::string_view) noexcept;

}  // namespace planetree::detail
