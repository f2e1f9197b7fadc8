#pragma once

#include <string>
#include <vector>

namespace planetree::render {

/// One thing that a picture's file says about the picture.
struct MetadataEntry {
  /// Words of ASCII letters, each with a capital, with one blank between them. At most 31
  /// characters: both PNG and EXR take such names.
  std::string key;
  std::string text;  ///< UTF-8 without control characters
};

using Metadata = std::vector<MetadataEntry>;

}  // namespace planetree::render
