#include "import/own_formats.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace planetree::importing {

bool isNamedForOwnReaders(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 5> kExtensions = {"", ".ply", ".stl", ".obj", ".off"};
  std::string extension = path.extension().string();
  for (char& c : extension)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

}  // namespace planetree::importing
