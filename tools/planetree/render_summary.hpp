#pragma once

#include "json_text.hpp"
#include "picture_file.hpp"
#include "picture_metadata.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace planetree::tool {

/// Where the time of a run went, in seconds of the clock on the wall. Rendering is divided as the
/// threads were busy.
struct RunTimes {
  double reading = 0.0;
  double building = 0.0;
  double tracing = 0.0;
  double shading = 0.0;
  double writing = 0.0;
};

[[nodiscard]] RunTimes runTimes(const FinishedPicture& picture, double writingSeconds);

/// "time: reading 0.02 s (1 %), ..."
[[nodiscard]] std::string timesText(const RunTimes& times);

/// What `--json` prints; docs/pictures.md lists it.
[[nodiscard]] Json summaryJson(const FinishedPicture& picture, const PictureFile& file,
                               const RunTimes& times);

}  // namespace planetree::tool
