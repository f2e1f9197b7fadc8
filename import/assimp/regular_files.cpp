#include "import/assimp/regular_files.hpp"

#include <filesystem>
#include <system_error>

namespace planetree::importing {

bool RegularFiles::Exists(const char* path) const {
  std::error_code ignored;
  return path != nullptr && std::filesystem::is_regular_file(path, ignored);
}

Assimp::IOStream* RegularFiles::Open(const char* path, const char* mode) {
  return Exists(path) ? DefaultIOSystem::Open(path, mode) : nullptr;
}

}  // namespace planetree::importing
