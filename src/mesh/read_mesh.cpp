#include <planetree/mesh/read_mesh.hpp>

#include "mesh/mesh_readers.hpp"
#include "support/read_file.hpp"
#include "support/text_lines.hpp"

#include <planetree/error.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace planetree {
namespace detail {
namespace {

enum class FileKind : std::uint8_t { Ply, StlText, StlBinary, Obj, Off };

constexpr MeshFormat formatOf(FileKind kind) noexcept {
  return kind == FileKind::Ply   ? MeshFormat::Ply
         : kind == FileKind::Obj ? MeshFormat::Obj
         : kind == FileKind::Off ? MeshFormat::Off
                                 : MeshFormat::Stl;
}

std::string_view textOf(std::span<const std::byte> bytes) noexcept {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  return lower;
}

/// The mark that some editors put before a text in UTF-8.
std::span<const std::byte> withoutByteOrderMark(std::span<const std::byte> bytes) noexcept {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return textOf(bytes).starts_with(kMark) ? bytes.subspan(kMark.size()) : bytes;
}

std::string_view firstWord(std::span<const std::byte> bytes) noexcept {
  TextLines lines(bytes);
  while (lines.next()) {
    std::string_view line = lines.line();
    const std::string_view word = takeWord(line);
    if (!word.empty())
      return word;
  }
  return {};
}

Error unknownFormat(const MeshInput& input) {
  const auto error = [&input](const std::string& problem, const std::string& advice) {
    return Error(ErrorCode::UnknownFormat, problem, advice, Error::Place{input.name});
  };
  const std::string_view text = textOf(input.bytes);
  if (text.empty())
    return error("the file is empty", "Export or copy it again");
  // gzip, zip, bzip2, xz, zstd
  constexpr std::array<std::string_view, 5> kPacked = {"\x1F\x8B", "PK\x03\x04", "BZh",
                                                       "\xFD\x37zXZ", "\x28\xB5\x2F\xFD"};
  const bool isPacked = std::any_of(kPacked.begin(), kPacked.end(), [text](std::string_view mark) {
    return text.starts_with(mark);
  });
  if (isPacked)
    return error("the file is compressed", "Unpack it first");
  return error("the file is in none of the formats that can be read",
               "Convert it to PLY, STL, OBJ or OFF");
}

/// What the bytes are, as far as their beginning tells; damage further on is the reader's affair.
FileKind detectKind(const MeshInput& input) {
  const std::string_view text = textOf(input.bytes);
  const bool isBinary = text.find('\0') != std::string_view::npos;
  const std::string_view word =
      firstWord(input.bytes.first(std::min(input.bytes.size(), std::size_t{4096})));
  if (text.starts_with("ply") && word == "ply")
    return FileKind::Ply;
  if (lowerCase(word) == "solid")
    return isBinary ? FileKind::StlBinary : FileKind::StlText;
  if (isOff(input.bytes))
    return FileKind::Off;
  if (isObj(input.bytes))
    return FileKind::Obj;
  // A damaged binary STL has nothing to be known by but its name.
  if (isBinary && lowerCase(input.name).ends_with(".stl"))
    return FileKind::StlBinary;
  throw unknownFormat(input);
}

template <std::floating_point T>
TriangleMesh<T> readBytes(MeshInput input, MeshReadReport* report) {
  // The size of a binary STL is a surer sign than the first bytes of anything else.
  FileKind kind = FileKind::StlBinary;
  if (!isStlBinary(input.bytes)) {
    input.bytes = withoutByteOrderMark(input.bytes);
    kind = detectKind(input);
  }
  MeshBuilder<T> builder(input, formatOf(kind));
  switch (kind) {
    case FileKind::Ply:
      readPly(input, builder);
      break;
    case FileKind::StlText:
      readStlText(input, builder);
      break;
    case FileKind::StlBinary:
      readStlBinary(input, builder);
      break;
    case FileKind::Obj:
      readObj(input, builder);
      break;
    case FileKind::Off:
      readOff(input, builder);
      break;
  }
  if (report)
    *report = builder.takeReport();
  return builder.takeMesh();
}

}  // namespace
}  // namespace detail

template <std::floating_point T>
TriangleMesh<T> readMesh(const std::filesystem::path& path, MeshReadReport* report) {
  const detail::FileContent content = detail::readFile(path);
  return detail::readBytes<T>({content.bytes(), path.string()}, report);
}

template <std::floating_point T>
TriangleMesh<T> readMesh(std::span<const std::byte> bytes, const std::string& name,
                         MeshReadReport* report) {
  return detail::readBytes<T>({bytes, name}, report);
}

template TriangleMesh<float> readMesh<float>(const std::filesystem::path&, MeshReadReport*);
template TriangleMesh<double> readMesh<double>(const std::filesystem::path&, MeshReadReport*);
template TriangleMesh<float> readMesh<float>(std::span<const std::byte>, const std::string&,
                                             MeshReadReport*);
template TriangleMesh<double> readMesh<double>(std::span<const std::byte>, const std::string&,
                                               MeshReadReport*);

}  // namespace planetree
