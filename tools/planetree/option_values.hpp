#pragma once

#include "picture_format.hpp"
#include "ray_files/table_format.hpp"

#include "render/framing.hpp"
#include "render/image.hpp"
#include "render/render_image.hpp"

#include <planetree/geometry/vec3.hpp>
#include <planetree/split/build_options.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

/// The values of options, from text. Each function throws `UsageError` that names the option and
/// says what it takes.
namespace planetree::tool {

/// An option as it stands on the command line.
struct OptionText {
  std::string_view name;  ///< "--size"
  std::string_view text;  ///< "800x600"
};

/// What `--camera` says.
struct CameraOption {
  Vec3f eye;
  Vec3f at;
  std::optional<float> fovDegrees;
};

/// What `--size` says.
struct SizeOption {
  std::uint32_t width = 800;
  std::optional<std::uint32_t> height = {};  ///< otherwise as the view is shaped
};

/// A shell that completes command lines.
enum class Shell : std::uint8_t { Bash, Zsh, Fish };

/// Build rules under the name that `--preset` takes.
using Preset = std::pair<std::string_view, BuildOptions>;

/// All presets of the library, from the quickest build to the slowest, and the textbook's.
[[nodiscard]] std::span<const Preset> presets() noexcept;

/// The most pixels of a picture: enough for the largest screens, and memory for them is at hand.
inline constexpr std::uint64_t kMaxPixelCount = std::uint64_t{1} << 26;

/// A whole number from `lowest` to `highest`.
[[nodiscard]] std::uint64_t parseWholeNumber(const OptionText& option, std::uint64_t lowest,
                                             std::uint64_t highest);

/// A number of bytes: "500000000", "500M" and "500MB" are the same, "477MiB" is about that.
[[nodiscard]] std::uint64_t parseByteCount(const OptionText& option);

/// A cost that `CostModel` takes: not negative, and finite.
[[nodiscard]] double parseCost(const OptionText& option);
/// A part of the whole: from 0 to less than 1.
[[nodiscard]] double parsePart(const OptionText& option);
/// A distance along a ray. It may be infinite, but must be a number.
[[nodiscard]] double parseDistance(const OptionText& option);
/// 32 bits, in decimal or as "0xFF".
[[nodiscard]] std::uint32_t parseMask(const OptionText& option);

/// "800x600", or "800" for the width alone: neither side is zero, and not too many pixels in all.
[[nodiscard]] SizeOption parseSize(const OptionText& option);
/// Throws `UsageError` if a picture has too many pixels.
void checkPixelCount(const OptionText& option, std::uint64_t width, std::uint64_t height);

/// "X,Y,W,H": the upper left corner of a part of a picture, and its size, which is not zero.
[[nodiscard]] render::PixelWindow parseCrop(const OptionText& option);

/// A time that is more than nothing.
[[nodiscard]] double parseSeconds(const OptionText& option);
/// How much two colours may differ: from 0 to 1.
[[nodiscard]] float parseThreshold(const OptionText& option);
/// Six images, with commas between them.
[[nodiscard]] std::array<std::filesystem::path, 6> parseCubeMap(const OptionText& option);

/// Degrees of a field of view.
[[nodiscard]] float parseFov(const OptionText& option);

/// "ex,ey,ez,ax,ay,az" with the field of view as an optional seventh number.
[[nodiscard]] CameraOption parseCamera(const OptionText& option);

/// The camera in the form that `parseCamera` reads, to the last bit.
[[nodiscard]] std::string cameraText(const render::Camera& camera);

[[nodiscard]] render::RenderMode parseMode(const OptionText& option);
[[nodiscard]] render::UpAxis parseUpAxis(const OptionText& option);
[[nodiscard]] BuildOptions parsePreset(const OptionText& option);
[[nodiscard]] PlanarRule parsePlanarRule(const OptionText& option);
/// "on" or "off".
[[nodiscard]] bool parseSwitch(const OptionText& option);
[[nodiscard]] Shell parseShell(const OptionText& option);
[[nodiscard]] TableFormat parseTableFormat(const OptionText& option);
[[nodiscard]] PictureFormat parsePictureFormat(const OptionText& option);

/// The names that `parseMode`, `parsePlanarRule` and `parseSwitch` read.
[[nodiscard]] std::string_view modeName(render::RenderMode mode) noexcept;
[[nodiscard]] std::string_view planarRuleName(PlanarRule rule) noexcept;
[[nodiscard]] std::string_view switchName(bool isOn) noexcept;

}  // namespace planetree::tool
