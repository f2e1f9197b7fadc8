#include "support/file_state.hpp"

#if defined(__linux__)
#include <sys/stat.h>
#endif

namespace planetree::detail {

#if defined(__linux__)
namespace {

std::optional<FileState> stateIn(const struct stat& status) noexcept {
  if (!S_ISREG(status.st_mode))
    return std::nullopt;
  return FileState{.size = static_cast<std::uint64_t>(status.st_size),
                   .seconds = status.st_mtim.tv_sec,
                   .nanoseconds = status.st_mtim.tv_nsec};
}

}  // namespace

std::optional<FileState> stateOf(int file) noexcept {
  struct stat status = {};
  return ::fstat(file, &status) == 0 ? stateIn(status) : std::nullopt;
}

std::optional<FileState> stateOf(std::FILE* file) noexcept {
  return stateOf(::fileno(file));
}

std::optional<FileState> stateOf(const std::filesystem::path& path) noexcept {
  struct stat status = {};
  return ::stat(path.c_str(), &status) == 0 ? stateIn(status) : std::nullopt;
}

#else

std::optional<FileState> stateOf(int /*file*/) noexcept {
  return std::nullopt;
}
std::optional<FileState> stateOf(std::FILE* /*file*/) noexcept {
  return std::nullopt;
}
std::optional<FileState> stateOf(const std::filesystem::path& /*path*/) noexcept {
  return std::nullopt;
}

#endif

}  // namespace planetree::detail
