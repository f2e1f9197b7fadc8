#include "import/import_mesh.hpp"

#include "import/own_formats.hpp"
#include "import/read_with_assimp.hpp"

#include "support/read_file.hpp"

#include <planetree/error.hpp>

#include <optional>
#include <system_error>
#include <utility>

namespace planetree::importing {
namespace {

namespace fs = std::filesystem;

const char* nameOf(MeshFormat format) noexcept {
  switch (format) {
    case MeshFormat::Ply:
      return "PLY";
    case MeshFormat::Stl:
      return "STL";
    case MeshFormat::Obj:
      return "OBJ";
    case MeshFormat::Off:
      return "OFF";
    case MeshFormat::Other:
      break;
  }
  return "other";
}

template <std::floating_point T>
TriangleMesh<T> readOwnFormats(const fs::path& path, ImportReport& report) {
  TriangleMesh<T> mesh = readMesh<T>(path, &report);
  report.formatName = nameOf(report.format);
  return mesh;
}

template <std::floating_point T>
TriangleMesh<T> readOtherFormats(const fs::path& path, ImportReport& report) {
  std::error_code unknown;
  const std::uintmax_t size = fs::file_size(path, unknown);
  return readWithAssimp<T>(path, usualLimits(unknown ? 0 : size), &report);
}

/// What `read` returns; nothing if it does not know the format.
template <std::floating_point T, class Read>
std::optional<TriangleMesh<T>> ifKnown(const Read& read) {
  try {
    return read();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::UnknownFormat)
      throw;
    return std::nullopt;
  }
}

/// Tries the reader that the name speaks for, and the other one if the content is not of its kind.
/// Names decide first because contents deceive: NFF scenes begin like OBJ files.
template <std::floating_point T>
TriangleMesh<T> readAny(const fs::path& path, ImportReport& report) {
  detail::requireReadable(path);
  // assimp goes back and forth in a file, which a pipe does not allow.
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored) || fs::file_size(path, ignored) == 0)
    return readOwnFormats<T>(path, report);

  const bool isOwnFirst = isNamedForOwnReaders(path);
  auto mesh = ifKnown<T>([&] {
    return isOwnFirst ? readOwnFormats<T>(path, report) : readOtherFormats<T>(path, report);
  });
  if (!mesh && isOwnFirst)
    mesh = ifKnown<T>([&] { return readOtherFormats<T>(path, report); });
  // If nobody knows the format, our own readers say what is to be said.
  return mesh ? std::move(*mesh) : readOwnFormats<T>(path, report);
}

}  // namespace

template <std::floating_point T>
TriangleMesh<T> importMesh(const fs::path& path, ImportReport* report) {
  ImportReport found;
  TriangleMesh<T> mesh = readAny<T>(path, found);
  if (report)
    *report = std::move(found);
  return mesh;
}

template TriangleMesh<float> importMesh<float>(const fs::path&, ImportReport*);
template TriangleMesh<double> importMesh<double>(const fs::path&, ImportReport*);

}  // namespace planetree::importing
