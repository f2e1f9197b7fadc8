#include "scene/json_format/json_text.hpp"

#include <algorithm>

namespace planetree::scene::json_format {

Error::Place JsonText::placeOf(std::size_t offset) const {
  const auto before = bytes_.first(std::min(offset, bytes_.size()));
  Error::Place place{.file = name_, .line = 1, .face = Error::kNone, .column = 1};
  for (const std::byte byte : before) {
    ++place.column;
    if (byte == std::byte{'\n'}) {
      ++place.line;
      place.column = 1;
    }
  }
  return place;
}

}  // namespace planetree::scene::json_format
