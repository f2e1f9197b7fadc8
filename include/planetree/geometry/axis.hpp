#pragma once

#include <array>
#include <cstdint>

namespace planetree {

/// The three coordinate axes; the value is the index of the component.
enum class Axis : std::uint8_t { X = 0, Y = 1, Z = 2 };

/// All axes in their fixed order, which is also the order that breaks ties between split planes.
inline constexpr std::array<Axis, 3> kAxes = {Axis::X, Axis::Y, Axis::Z};

/// Lower-case name of the axis: "x", "y" or "z".
[[nodiscard]] constexpr const char* axisName(Axis axis) noexcept {
  return axis == Axis::X ? "x" : axis == Axis::Y ? "y" : "z";
}

}  // namespace planetree
