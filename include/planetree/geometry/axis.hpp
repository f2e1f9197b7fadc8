#pragma once

#include <array>
#include <cstdint>

namespace planetree {

/// The three coordinate axes; the value is the index of the component.
enum class Axis : std::uint8_t { X = 0, Y = 1, Z = 2 };

/// All axes in their fixed order, which is also the order that breaks ties between split planes.
inline constexpr std::array<Axis, 3> kAxes = {Axis::X, Axis::Y, Axis::Z};

/// The axis that follows in turn: Y after X, Z after Y, X after Z. Without a branch, as for a ray
/// none could foresee the axis: two bits for each.
[[nodiscard]] constexpr Axis nextAxis(Axis axis) noexcept {
  return static_cast<Axis>(0b00'10'01u >> 2u * static_cast<unsigned>(axis) & 3u);
}
static_assert(nextAxis(Axis::X) == Axis::Y && nextAxis(Axis::Y) == Axis::Z &&
              nextAxis(Axis::Z) == Axis::X);

/// Lower-case name of the axis: "x", "y" or "z".
[[nodiscard]] constexpr const char* axisName(Axis axis) noexcept {
  return axis == Axis::X ? "x" : axis == Axis::Y ? "y" : "z";
}

}  // namespace planetree
