#pragma once

#include "compare/compare_presets.hpp"
#include "json_text.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace planetree::tool {

/// What was compared.
struct ComparedModel {
  std::string name;
  std::string objectName;  ///< "triangle" or "object"
  std::uint64_t objectCount = 0;
  std::uint64_t primaryRayCount = 0;
  std::uint64_t aoRayCount = 0;
  std::uint64_t randomRayCount = 0;
};

/// A table for people: a line for each figure, a column for each preset.
[[nodiscard]] std::string comparePage(const ComparedModel& model,
                                      const std::vector<PresetFigures>& figures);

/// The same for programs, for the key "presets".
[[nodiscard]] Json presetsJson(const ComparedModel& model,
                               const std::vector<PresetFigures>& figures);

/// The figures of one preset in one line.
[[nodiscard]] std::string figuresLine(const ComparedModel& model, const PresetFigures& figures);

}  // namespace planetree::tool
