#include "option_values.hpp"
#include "instruments/ray_option.hpp"
#include "usage_error.hpp"

#include "support/byte_stream.hpp"
#include "support/promise.hpp"

#include <cmath>
#include <limits>
#include <string_view>

// Any text as the value of an option; the first byte says of which kind of option.

namespace planetree::fuzz {
namespace {

void requireSoundCamera(const tool::OptionText& option) {
  const tool::CameraOption camera = tool::parseCamera(option);
  require(isFinite(camera.eye) && isFinite(camera.at), "a camera stands somewhere");
  const render::Camera whole{
      .eye = camera.eye, .at = camera.at, .fovDegrees = camera.fovDegrees.value_or(40.0f)};
  const std::string text = tool::cameraText(whole);
  const tool::CameraOption again = tool::parseCamera({"--camera", text});
  require(again.eye == camera.eye && again.at == camera.at && again.fovDegrees == whole.fovDegrees,
          "a camera that is written can be read");
}

template <class T>
void requireSoundRay(const tool::OptionText& option) {
  const Ray<T> ray = tool::parseRay<T>(option, {});
  require(isFinite(ray.origin) && isFinite(ray.direction) && ray.tMin <= ray.tMax,
          "a ray that is taken can hit");
}

void parse(unsigned kind, const tool::OptionText& option) {
  constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();
  switch (kind) {
    case 0: {
      const std::uint64_t number = tool::parseWholeNumber(option, 3, 1000);
      return require(number >= 3 && number <= 1000, "a whole number is in its range");
    }
    case 1:
      return static_cast<void>(tool::parseWholeNumber(option, 0, kLargest));
    case 2:
      return static_cast<void>(tool::parseByteCount(option));
    case 3: {
      const double cost = tool::parseCost(option);
      return require(cost >= 0.0 && std::isfinite(cost), "a cost is one");
    }
    case 4: {
      const double part = tool::parsePart(option);
      return require(part >= 0.0 && part < 1.0, "a part is less than the whole");
    }
    case 5:
      return require(!std::isnan(tool::parseDistance(option)), "a distance is a number");
    case 6:
      return static_cast<void>(tool::parseMask(option));
    case 7: {
      const tool::SizeOption size = tool::parseSize(option);
      const std::uint64_t count = std::uint64_t{size.width} * size.height.value_or(1);
      return require(count > 0 && count <= tool::kMaxPixelCount, "a picture is not too large");
    }
    case 8: {
      const float degrees = tool::parseFov(option);
      return require(degrees > 0.0f && degrees < 180.0f, "an angle of view is less than a half");
    }
    case 9:
      return requireSoundCamera(option);
    case 10:
      return requireSoundRay<float>(option);
    case 11:
      return requireSoundRay<double>(option);
    case 12:
      return static_cast<void>(tool::parseMode(option));
    case 13:
      return static_cast<void>(tool::parsePreset(option));
    case 14:
      return static_cast<void>(tool::parsePlanarRule(option));
    case 15:
      return static_cast<void>(tool::parseTableFormat(option));
    default:
      return static_cast<void>(tool::parsePictureFormat(option));
  }
}

}  // namespace
}  // namespace planetree::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace planetree;
  fuzz::ByteStream input(data, size);
  const unsigned kind = input.takeBelow(17);
  try {
    // The system hands no text over beyond a zero.
    const std::string_view text = input.text();
    fuzz::parse(kind, {"--option", text.substr(0, text.find('\0'))});
  } catch (const tool::UsageError& error) {
    const std::string_view text = error.what();
    fuzz::require(text.starts_with("--option"), "a usage error names the option");
    fuzz::require(text.ends_with('.'), "a usage error gives advice");
  }
  return 0;
}
