#pragma once

#include "import/import_mesh.hpp"

#include "support/promise.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace planetree::fuzz {

/// What another process said is fit to be shown in a terminal.
inline void requireSoundText(const std::string& text) {
  require(std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c < '\x7F'; }),
          "texts from outside have no control characters");
  require(text.size() < 400, "texts from outside are short");
}

inline void requireSoundTexts(const importing::ImportReport& report) {
  require(report.remarks.size() <= report.remarkCount, "remarks that are kept are counted");
  for (const std::string& remark : report.remarks)
    requireSoundText(remark);
  requireSoundText(report.formatName);
}

}  // namespace planetree::fuzz
