#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace planetree::test {

/// One channel of an EXR file.
struct ExrChannel {
  bool isHalf = false;
  std::vector<float> values;  ///< row by row from the top left
};

/// An EXR file as OpenEXR reads it.
struct ExrFile {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  /// Where its first pixel is in the picture that it is a part of, and how large that is.
  int firstX = 0;
  int firstY = 0;
  std::uint32_t wholeWidth = 0;
  std::uint32_t wholeHeight = 0;
  std::map<std::string, ExrChannel> channels;
  std::map<std::string, std::string> texts;  ///< its string attributes
};

/// Reads the bytes of an EXR file; nothing if they are not one.
[[nodiscard]] std::optional<ExrFile> readExr(const std::string& bytes);

}  // namespace planetree::test
