#pragma once

#include <filesystem>

namespace planetree::importing {

/// Whether the name is one of PLY, STL, OBJ or OFF, or says nothing.
[[nodiscard]] bool isNamedForOwnReaders(const std::filesystem::path& path);

}  // namespace planetree::importing
