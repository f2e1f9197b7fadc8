#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace planetree::importing {

/// The file that a model in `folder` means by a reference. Formats know references relative to the
/// model, also to folders above it, written as paths of Unix or Windows or as URIs. Absolute paths
/// are those of the machine where the model was made: only their last part is looked for, beside
/// the model. So is that of a relative path which leads nowhere. Nothing is opened but files.
[[nodiscard]] std::optional<std::filesystem::path> findTexture(const std::string& reference,
                                                               const std::filesystem::path& folder);

}  // namespace planetree::importing
