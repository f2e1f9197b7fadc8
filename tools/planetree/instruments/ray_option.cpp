#include "instruments/ray_option.hpp"

#include "usage_error.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

namespace planetree::tool {

namespace {

constexpr const char* kForm = "Give ox,oy,oz,dx,dy,dz[,tMin,tMax], such as 0,0,5,0,0,-1.";

[[noreturn]] void refuse(const OptionText& option, std::string_view reason,
                         std::string_view advice = kForm) {
  throw UsageError(fmt::format("{} {}: {}", option.name, option.text, reason), std::string(advice));
}

std::string_view withoutBlanksAndPlus(std::string_view field) {
  const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
  while (!field.empty() && isBlank(field.front()))
    field.remove_prefix(1);
  while (!field.empty() && isBlank(field.back()))
    field.remove_suffix(1);
  const bool hasPlus = field.size() > 1 && field[0] == '+' && field[1] != '-';
  return hasPlus ? field.substr(1) : field;
}

/// What lies outside the range of T becomes infinity or zero.
template <class T>
std::optional<T> numberFrom(std::string_view field) {
  T number{};
  const char* const end = field.data() + field.size();
  const auto [parsedEnd, error] = std::from_chars(field.data(), end, number);
  if (parsedEnd != end || error == std::errc::invalid_argument)
    return std::nullopt;
  if (error == std::errc{})
    return number;
  if constexpr (std::same_as<T, float>) {
    const std::optional<double> wide = numberFrom<double>(field);
    return wide ? std::optional(static_cast<float>(*wide)) : std::nullopt;
  } else {
    return std::nullopt;
  }
}

template <class T>
void checkCanHit(const Ray<T>& ray, const OptionText& option) {
  if (!isFinite(ray.origin) || !isFinite(ray.direction)) {
    refuse(option, "the origin or the direction is not finite",
           std::same_as<T, float> ? "Give finite numbers; beyond the range of float, with --double."
                                  : "Give finite numbers.");
  }
  if (ray.direction == Vec3<T>{}) {
    refuse(option, "the direction is zero", "Give one that is not, such as 0,0,-1.");
  }
  if (std::isnan(ray.tMin) || std::isnan(ray.tMax))
    refuse(option, "a limit of t is not a number");
  if (ray.tMin > ray.tMax) {
    refuse(option, fmt::format("it begins at t = {} and ends before, at {}", ray.tMin, ray.tMax),
           "Give a smaller tMin or a larger tMax.");
  }
}

}  // namespace

template <std::floating_point T>
Ray<T> parseRay(const OptionText& option, const RayLimits& limits) {
  std::array<T, 8> numbers = {
      0, 0, 0, 0, 0, 0, static_cast<T>(limits.tMin), static_cast<T>(limits.tMax)};
  std::size_t count = 0;
  std::string_view rest = option.text;
  for (bool isLast = false; !isLast; ++count) {
    const std::size_t comma = rest.find(',');
    isLast = comma == std::string_view::npos;
    const std::string_view field = rest.substr(0, comma);
    const std::optional<T> number = numberFrom<T>(withoutBlanksAndPlus(field));
    if (!number)
      refuse(option, fmt::format("\"{}\" is not a number", field));
    if (count < numbers.size())
      numbers[count] = *number;
    rest.remove_prefix(isLast ? rest.size() : comma + 1);
  }
  if (count != 6 && count != 8)
    refuse(option, fmt::format("{} numbers instead of 6 or 8", count));

  const auto& n = numbers;
  const Ray<T> ray{
      .origin = {n[0], n[1], n[2]}, .direction = {n[3], n[4], n[5]}, .tMin = n[6], .tMax = n[7]};
  checkCanHit(ray, option);
  return ray;
}

template Ray<float> parseRay<float>(const OptionText&, const RayLimits&);
template Ray<double> parseRay<double>(const OptionText&, const RayLimits&);

}  // namespace planetree::tool
