#include "support/parse_number.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>
#include <system_error>

namespace planetree::detail {
namespace {

/// `std::from_chars` knows no plus sign.
std::string_view withoutPlus(std::string_view word) noexcept {
  const bool hasPlus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return hasPlus ? word.substr(1) : word;
}

template <class Number>
struct Parsed {
  Number value = Number(0);
  bool isWhole = false;  ///< the word is one number from its first to its last character
  bool isOutOfRange = false;
};

template <class Number>
Parsed<Number> parse(std::string_view word) noexcept {
  Parsed<Number> parsed;
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, parsed.value);
  parsed.isWhole = !word.empty() && result.ptr == end && result.ec != std::errc::invalid_argument;
  parsed.isOutOfRange = result.ec == std::errc::result_out_of_range;
  return parsed;
}

/// True if the magnitude of a decimal number, whose value is not zero, is at least one. Tells
/// overflow from underflow, which `std::from_chars` reports alike.
bool isAtLeastOne(std::string_view number) noexcept {
  const std::size_t exponentMark = number.find_first_of("eE");
  const std::string_view digits = number.substr(0, exponentMark);
  const std::size_t firstDigit = digits.find_first_of("123456789");
  const std::size_t point = std::min(digits.find('.'), digits.size());
  if (firstDigit == std::string_view::npos)
    return false;
  // The power of ten of the first digit, plus one: positive for 1, zero for 0.1.
  std::int64_t power = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(firstDigit);
  if (firstDigit > point)
    ++power;
  if (exponentMark == std::string_view::npos)
    return power > 0;
  const std::int64_t exponent = parseInteger(number.substr(exponentMark + 1)).value_or(0);
  return exponent > -power;
}

}  // namespace

template <std::floating_point T>
std::optional<T> parseNumber(std::string_view word) noexcept {
  const std::string_view number = withoutPlus(word);
  const Parsed<T> parsed = parse<T>(number);
  if (!parsed.isWhole)
    return std::nullopt;
  if (!parsed.isOutOfRange)
    return parsed.value;
  const T magnitude = isAtLeastOne(number) ? std::numeric_limits<T>::infinity() : T(0);
  return number.front() == '-' ? -magnitude : magnitude;
}

std::optional<std::int64_t> parseInteger(std::string_view word) noexcept {
  const std::string_view number = withoutPlus(word);
  const Parsed<std::int64_t> parsed = parse<std::int64_t>(number);
  if (!parsed.isWhole)
    return std::nullopt;
  if (!parsed.isOutOfRange)
    return parsed.value;
  using Limits = std::numeric_limits<std::int64_t>;
  return number.front() == '-' ? Limits::min() : Limits::max();
}

template std::optional<float> parseNumber<float>(std::string_view) noexcept;
template std::optional<double> parseNumber<double>(std::string_view) noexcept;

}  // namespace planetree::detail
