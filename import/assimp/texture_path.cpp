#include "import/assimp/texture_path.hpp"

#include <algorithm>
#include <string_view>
#include <system_error>

namespace planetree::importing {
namespace {

namespace fs = std::filesystem;

int hexadecimal(char c) noexcept {
  if (c >= '0' && c <= '9')
    return c - '0';
  if (c >= 'a' && c <= 'f')
    return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// "my%20wood.png" as "my wood.png".
std::string percentDecoded(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = i + 2 < uri.size() ? hexadecimal(uri[i + 1]) : -1;
    const int low = i + 2 < uri.size() ? hexadecimal(uri[i + 2]) : -1;
    if (uri[i] == '%' && high >= 0 && low >= 0 && high + low > 0) {
      text += static_cast<char>(high * 16 + low);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

/// Without the blanks and quotation marks around it, which MTL files may have.
std::string_view bare(std::string_view text) noexcept {
  constexpr std::string_view kAround = " \t\r\n\"";
  const std::size_t begin = text.find_first_not_of(kAround);
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(kAround) - begin + 1);
}

/// "/...", "C:...", "file:..." and other URIs with a scheme.
bool isAbsolute(std::string_view path) noexcept {
  const std::size_t end = path.find_first_of("/:");
  return end != std::string_view::npos && (end == 0 || path[end] == ':');
}

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::optional<fs::path> findOne(const std::string& reference, const fs::path& folder) {
  const fs::path name = fs::path(reference).filename();
  if (name.empty())
    return std::nullopt;
  if (!isAbsolute(reference) && isFile(folder / reference))
    return folder / reference;
  if (isFile(folder / name))
    return folder / name;
  return std::nullopt;
}

}  // namespace

std::optional<fs::path> findTexture(const std::string& reference, const fs::path& folder) {
  std::string text(bare(reference));
  if (text.find('\0') != std::string::npos)
    return std::nullopt;
  if (auto found = findOne(text, folder))
    return found;
  std::replace(text.begin(), text.end(), '\\', '/');
  if (auto found = findOne(text, folder))
    return found;
  return findOne(percentDecoded(text), folder);
}

}  // namespace planetree::importing
