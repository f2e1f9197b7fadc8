#include "option_values.hpp"

#include "usage_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>
#include <vector>

namespace planetree::tool {

namespace {

constexpr float kNarrowestFov = 0.01f;
constexpr float kWidestFov = 179.0f;

[[noreturn]] void refuse(const OptionText& option, std::string_view reason,
                         std::string_view advice) {
  throw UsageError(fmt::format("{} {}: {}", option.name, option.text, reason), std::string(advice));
}

std::string_view withoutBlanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The number that the whole text spells, or nothing. Does not depend on the locale.
template <class Number>
std::optional<Number> numberFrom(std::string_view text, auto... base) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [parsedEnd, error] = std::from_chars(text.data(), end, number, base...);
  if (error != std::errc{} || parsedEnd != end)
    return std::nullopt;
  return number;
}

std::vector<std::string_view> fieldsBetweenCommas(std::string_view text) {
  std::vector<std::string_view> fields;
  for (std::size_t comma = text.find(','); comma != std::string_view::npos;
       comma = text.find(',')) {
    fields.push_back(text.substr(0, comma));
    text.remove_prefix(comma + 1);
  }
  fields.push_back(text);
  return fields;
}

bool isFov(float degrees) {
  return degrees >= kNarrowestFov && degrees <= kWidestFov;
}

std::string fovAdvice() {
  return fmt::format("Give an angle from {} to {} degrees, such as 40.", kNarrowestFov, kWidestFov);
}

template <class Value, std::size_t N>
using Choices = std::array<std::pair<std::string_view, Value>, N>;

constexpr Choices<PlanarRule, 2> kPlanarRules = {
    {{"cheaper-side", PlanarRule::CheaperSide}, {"normal-sign", PlanarRule::NormalSign}}};
constexpr Choices<bool, 2> kSwitches = {{{"on", true}, {"off", false}}};

constexpr Choices<BuildOptions, 4> kPresets = {{{"fast", BuildOptions::fast()},
                                                {"balanced", BuildOptions::balanced()},
                                                {"high", BuildOptions::high()},
                                                {"textbook", BuildOptions::textbook()}}};

/// What stands behind a number of bytes, but for a B at the end.
constexpr Choices<std::uint64_t, 10> kByteUnits = {{{"", 1},
                                                    {"k", 1'000},
                                                    {"K", 1'000},
                                                    {"M", 1'000'000},
                                                    {"G", 1'000'000'000},
                                                    {"T", 1'000'000'000'000},
                                                    {"Ki", std::uint64_t{1} << 10u},
                                                    {"Mi", std::uint64_t{1} << 20u},
                                                    {"Gi", std::uint64_t{1} << 30u},
                                                    {"Ti", std::uint64_t{1} << 40u}}};

/// The value of a choice by its name.
template <class Value, std::size_t N>
Value choose(const OptionText& option, const Choices<Value, N>& choices) {
  std::string names;
  for (const auto& [name, value] : choices) {
    if (name == option.text)
      return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  refuse(option, "there is no such choice", fmt::format("Give one of {}.", names));
}

/// The name of a choice by its value.
template <class Value, std::size_t N>
std::string_view nameOf(Value value, const Choices<Value, N>& choices) noexcept {
  for (const auto& [name, chosen] : choices) {
    if (chosen == value)
      return name;
  }
  return {};
}

}  // namespace

std::span<const Preset> presets() noexcept {
  return kPresets;
}

std::uint64_t parseWholeNumber(const OptionText& option, std::uint64_t lowest,
                               std::uint64_t highest) {
  const auto number = numberFrom<std::uint64_t>(option.text);
  if (number && *number >= lowest && *number <= highest)
    return *number;
  refuse(option, "not a whole number in range",
         fmt::format("Give a number from {} to {}.", lowest, highest));
}

std::uint64_t parseByteCount(const OptionText& option) {
  const std::size_t digitCount =
      std::min(option.text.find_first_not_of("0123456789"), option.text.size());
  const auto number = numberFrom<std::uint64_t>(option.text.substr(0, digitCount));
  std::string_view unit = option.text.substr(digitCount);
  if (unit.ends_with('B'))
    unit.remove_suffix(1);
  for (const auto& [name, factor] : kByteUnits) {
    if (number && name == unit && *number <= std::numeric_limits<std::uint64_t>::max() / factor)
      return *number * factor;
  }
  refuse(option, "not a number of bytes", "Give a whole number, such as 500M or 2GiB.");
}

double parseCost(const OptionText& option) {
  // Only ratios matter; what is summed up from larger ones would not be finite.
  constexpr double kHighest = 1e9;
  const auto cost = numberFrom<double>(option.text);
  if (!cost || !(*cost >= 0.0 && *cost <= kHighest))
    refuse(option, "not a cost", "Give a number from 0 to 1e9, such as 1.5.");
  return *cost;
}

double parsePart(const OptionText& option) {
  const auto part = numberFrom<double>(option.text);
  if (!part || !(*part >= 0.0 && *part < 1.0))
    refuse(option, "not a number in range", "Give a number from 0 to less than 1, such as 0.2.");
  return *part;
}

double parseDistance(const OptionText& option) {
  const auto distance = numberFrom<double>(option.text);
  if (!distance || std::isnan(*distance))
    refuse(option, "not a distance", "Give a number, such as 0.001, or inf.");
  return *distance;
}

std::uint32_t parseMask(const OptionText& option) {
  const bool isHexadecimal = option.text.starts_with("0x") || option.text.starts_with("0X");
  const auto mask = isHexadecimal ? numberFrom<std::uint32_t>(option.text.substr(2), 16)
                                  : numberFrom<std::uint32_t>(option.text);
  if (!mask)
    refuse(option, "not a mask of 32 bits", "Give a whole number, such as 3 or 0xFF.");
  return *mask;
}

void checkPixelCount(const OptionText& option, std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0)
    refuse(option, "a picture without pixels", "Give at least 1x1.");
  if (width > kMaxPixelCount / height) {
    refuse(option, "too large a picture",
           fmt::format("Give at most {} pixels, such as 8192x8192.", kMaxPixelCount));
  }
}

SizeOption parseSize(const OptionText& option) {
  const std::size_t cross = option.text.find('x');
  const bool isWidthAlone = cross == std::string_view::npos;
  const auto width = numberFrom<std::uint64_t>(option.text.substr(0, cross));
  const auto height =
      isWidthAlone ? std::uint64_t{1} : numberFrom<std::uint64_t>(option.text.substr(cross + 1));
  if (!width || !height)
    refuse(option, "not a size", "Give width x height, such as 800x600, or the width alone.");
  checkPixelCount(option, *width, *height);
  SizeOption size{.width = static_cast<std::uint32_t>(*width)};
  if (!isWidthAlone)
    size.height = static_cast<std::uint32_t>(*height);
  return size;
}

render::PixelWindow parseCrop(const OptionText& option) {
  std::vector<std::uint32_t> numbers;
  for (const std::string_view field : fieldsBetweenCommas(option.text)) {
    const auto number = numberFrom<std::uint32_t>(withoutBlanks(field));
    if (!number) {
      refuse(option, fmt::format("\"{}\" is not a number of pixels", field),
             "Give X,Y,W,H: the upper left corner of the part, its width and its height.");
    }
    numbers.push_back(*number);
  }
  if (numbers.size() != 4) {
    refuse(option, fmt::format("{} numbers instead of 4", numbers.size()),
           "Give X,Y,W,H: the upper left corner of the part, its width and its height.");
  }
  checkPixelCount(option, numbers[2], numbers[3]);
  return {.x = numbers[0], .y = numbers[1], .size = {numbers[2], numbers[3]}};
}

double parseSeconds(const OptionText& option) {
  const auto seconds = numberFrom<double>(option.text);
  if (!seconds || !(*seconds > 0.0) || std::isinf(*seconds))
    refuse(option, "not a time", "Give a number of seconds, such as 5.");
  return *seconds;
}

float parseThreshold(const OptionText& option) {
  const auto threshold = numberFrom<float>(option.text);
  if (!threshold || !(*threshold >= 0.0f && *threshold <= 1.0f))
    refuse(option, "not a difference of colours", "Give a number from 0 to 1, such as 0.05.");
  return *threshold;
}

std::array<std::filesystem::path, 6> parseCubeMap(const OptionText& option) {
  const std::vector<std::string_view> fields = fieldsBetweenCommas(option.text);
  std::array<std::filesystem::path, 6> paths;
  const std::string advice = "Give six images: posx,negx,posy,negy,posz,negz.";
  if (fields.size() != paths.size())
    refuse(option, fmt::format("{} instead of 6", fields.size()), advice);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (fields[i].empty())
      refuse(option, "a name is empty", advice);
    paths[i] = fields[i];
  }
  return paths;
}

float parseFov(const OptionText& option) {
  const auto degrees = numberFrom<float>(option.text);
  if (!degrees || !isFov(*degrees))
    refuse(option, "not a field of view", fovAdvice());
  return *degrees;
}

CameraOption parseCamera(const OptionText& option) {
  std::vector<float> numbers;
  for (const std::string_view field : fieldsBetweenCommas(option.text)) {
    const auto number = numberFrom<float>(withoutBlanks(field));
    if (!number || !std::isfinite(*number)) {
      refuse(option, fmt::format("\"{}\" is not a finite number", field),
             "Give ex,ey,ez,ax,ay,az[,fov]: the eye, the point it looks at, the field of view.");
    }
    numbers.push_back(*number);
  }
  if (numbers.size() != 6 && numbers.size() != 7) {
    refuse(option, fmt::format("{} numbers instead of 6 or 7", numbers.size()),
           "Give ex,ey,ez,ax,ay,az[,fov]: the eye, the point it looks at, the field of view.");
  }
  const CameraOption camera{
      .eye = {numbers[0], numbers[1], numbers[2]},
      .at = {numbers[3], numbers[4], numbers[5]},
      .fovDegrees = numbers.size() == 7 ? std::optional(numbers[6]) : std::nullopt};
  if (camera.eye == camera.at) {
    refuse(option, "the eye is the point it looks at", "Move one of the two.");
  }
  if (camera.fovDegrees && !isFov(*camera.fovDegrees)) {
    refuse(option, "the seventh number is not a field of view", fovAdvice());
  }
  return camera;
}

std::string cameraText(const render::Camera& camera) {
  return fmt::format("{},{},{},{},{},{},{}", camera.eye.x, camera.eye.y, camera.eye.z, camera.at.x,
                     camera.at.y, camera.at.z, camera.fovDegrees);
}

render::RenderMode parseMode(const OptionText& option) {
  using render::RenderMode;
  return choose<RenderMode, 6>(option, {{{"whitted", RenderMode::Whitted},
                                         {"ao", RenderMode::AmbientOcclusion},
                                         {"normals", RenderMode::Normals},
                                         {"depth", RenderMode::Depth},
                                         {"albedo", RenderMode::Albedo},
                                         {"heat", RenderMode::Heat}}});
}

render::UpAxis parseUpAxis(const OptionText& option) {
  return choose<render::UpAxis, 2>(option, {{{"y", render::UpAxis::Y}, {"z", render::UpAxis::Z}}});
}

BuildOptions parsePreset(const OptionText& option) {
  return choose(option, kPresets);
}

PlanarRule parsePlanarRule(const OptionText& option) {
  return choose(option, kPlanarRules);
}

bool parseSwitch(const OptionText& option) {
  return choose(option, kSwitches);
}

Shell parseShell(const OptionText& option) {
  return choose<Shell, 3>(option,
                          {{{"bash", Shell::Bash}, {"zsh", Shell::Zsh}, {"fish", Shell::Fish}}});
}

TableFormat parseTableFormat(const OptionText& option) {
  return choose<TableFormat, 2>(option, {{{"csv", TableFormat::Csv}, {"npy", TableFormat::Npy}}});
}

PictureFormat parsePictureFormat(const OptionText& option) {
  return choose<PictureFormat, 2>(option,
                                  {{{"png", PictureFormat::Png}, {"exr", PictureFormat::Exr}}});
}

std::string_view modeName(render::RenderMode mode) noexcept {
  switch (mode) {
    case render::RenderMode::Normals:
      return "normals";
    case render::RenderMode::Depth:
      return "depth";
    case render::RenderMode::Heat:
      return "heat";
    case render::RenderMode::Whitted:
      return "whitted";
    case render::RenderMode::Albedo:
      return "albedo";
    case render::RenderMode::AmbientOcclusion:
      break;
  }
  return "ao";
}

std::string_view planarRuleName(PlanarRule rule) noexcept {
  return nameOf(rule, kPlanarRules);
}

std::string_view switchName(bool isOn) noexcept {
  return nameOf(isOn, kSwitches);
}

}  // namespace planetree::tool
