#pragma once

#include "json_text.hpp"

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/vec3.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <string>

/// Numbers for JSON that keep every bit and no more digits than they need.
namespace planetree::tool {

/// JSON knows doubles only, and a float as a double has a long tail of digits. The double that is
/// closest to the float's shortest text has none, and rounds to the same float. Null stands for
/// what is not finite.
[[nodiscard]] inline Json exactJson(float number) {
  if (!std::isfinite(number))
    return nullptr;
  const std::string text = fmt::format("{}", number);
  double shortest = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), shortest);
  return shortest;
}

[[nodiscard]] inline Json exactJson(double number) {
  return std::isfinite(number) ? Json(number) : Json(nullptr);
}

template <class T>
[[nodiscard]] Json exactJson(const Vec3<T>& vector) {
  return Json::array({exactJson(vector.x), exactJson(vector.y), exactJson(vector.z)});
}

[[nodiscard]] inline Json exactJson(const Box3& box) {
  return {{"lower", exactJson(box.lower)}, {"upper", exactJson(box.upper)}};
}

}  // namespace planetree::tool
